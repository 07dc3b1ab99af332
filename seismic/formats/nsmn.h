// The older text files of Turkey's national network (NSMN, AFAD): 17 lines "LABEL : value", a line of titles,
// then three columns in gal. The header's "RAW PGA VALUES" are those of the samples without their mean.
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_nsmn(const FileText& text);
std::vector<Record> read_nsmn(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
