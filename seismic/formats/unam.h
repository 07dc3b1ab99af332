// Instituto de Ingenieria, UNAM (Mexico), "archivo estandar de aceleracion" 2.0: lines "LABEL : value" with
// one entry for each channel between slashes, then a column for each channel.
//
//   VEL. DE MUESTREO, C1-C6 (muestras/s)   : /250/250/250
//   UNIDADES DE LOS DATOS                  : Gal (cm/s/s)
//   FORMATO DATOS (FORTRAN,10 campos/dato) : 3F10.3
//      CANAL-1   CANAL-2   CANAL-3
//            V      N90E      N00E
//
// The stated number of samples is not reliable: whatever rows there are beyond it are kept, with a warning.
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_unam(const FileText& text);
std::vector<Record> read_unam(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
