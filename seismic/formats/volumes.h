// The family of formats that grew out of Caltech's volumes of digitised film: CSMIP (CDMG, CGS), USC and
// Caltech, RENADIC of Chile, BHRC of Iran. A file holds its channels one after another, each with 13 or 25
// lines of text, 100 integers, 50 or 100 reals, and data.
//
//   volume 1, as digitised     "NO. OF POINTS = 11999", then (time, value) pairs in s and g/10; BHRC has
//                              values only
//   volume 2, corrected        "7500 points of accel data equally spaced at .010 sec, in cm/sec2. (8f10.6)",
//                              then velocity and displacement the same way
//
// "/&" ends a channel. Integers and fields touch ("110015000", "30.000000-999.00000"), so that the widths
// come from the stated Fortran format or from the first line of data. Volume 3, spectra, is refused.
// (Hudson, Trifunac and Brady 1969 ff., EERL, "Strong motion earthquake accelerograms"; Shakal and Huang
// 1985, OSMS 85-03.)
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_csmip_v2(const FileText& text);
std::vector<Record> read_csmip_v2(const FileText& text, const ReadOptions& options);

bool is_csmip_v1(const FileText& text);
std::vector<Record> read_csmip_v1(const FileText& text, const ReadOptions& options);

bool is_usc(const FileText& text);
std::vector<Record> read_usc(const FileText& text, const ReadOptions& options);

bool is_renadic(const FileText& text);
std::vector<Record> read_renadic(const FileText& text, const ReadOptions& options);

bool is_bhrc(const FileText& text);
std::vector<Record> read_bhrc(const FileText& text, const ReadOptions& options);

/// Volume 3: response and Fourier spectra. Reading it throws NotAcceleration.
bool is_volume_3(const FileText& text);
std::vector<Record> read_volume_3(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
