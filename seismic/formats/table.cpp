#include <array>

#include "seismic/formats/columns.h"
#include "seismic/formats/cosmos.h"
#include "seismic/formats/csmnc.h"
#include "seismic/formats/cwa.h"
#include "seismic/formats/dyna.h"
#include "seismic/formats/format.h"
#include "seismic/formats/geonet.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/knet_csv.h"
#include "seismic/formats/miniseed.h"
#include "seismic/formats/nsmn.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/formats/rec_shape.h"
#include "seismic/formats/record_csv.h"
#include "seismic/formats/sac.h"
#include "seismic/formats/sibling_names.h"
#include "seismic/formats/smc.h"
#include "seismic/formats/unam.h"
#include "seismic/formats/volumes.h"

namespace dougong::seismic {
namespace {

// Most formats keep one component a file.
template <Record (*read)(const FileText&, const ReadOptions&)>
std::vector<Record> one(const FileText& text, const ReadOptions& options) {
  std::vector<Record> records;
  records.push_back(read(text, options));
  return records;
}

}  // namespace

std::span<const Format> formats() {
  static constexpr std::array table = {
      Format{"miniseed", "miniSEED", is_miniseed, read_miniseed},
      Format{"sac", "SAC", is_sac, one<read_sac>},
      Format{"knet", "K-NET/KiK-net ASCII", is_knet, one<read_knet>, knet_siblings},
      Format{"knet-csv", "K-NET/KiK-net CSV", is_knet_csv, read_knet_csv},
      Format{"record-csv", "Dougong CSV", is_record_csv, read_record_csv},
      Format{"csmnc", "CSMNC uncorrected", is_csmnc, one<read_csmnc>, sibling_names},
      Format{"rec", "normalised .rec shape", is_rec_shape, one<read_rec_shape>},
      Format{"dyna", "DYNA 1.2", is_dyna, one<read_dyna>, dyna_siblings},
      Format{"nsmn", "NSMN text", is_nsmn, read_nsmn},
      Format{"cosmos", "COSMOS v1.20", is_cosmos, read_cosmos},
      Format{"geonet", "GeoNet V1A/V2A", is_geonet, read_geonet},
      Format{"volume-3", "spectra (volume 3)", is_volume_3, read_volume_3},
      Format{"usc", "USC/Caltech volumes", is_usc, read_usc},
      Format{"csmip-v2", "CSMIP V2", is_csmip_v2, read_csmip_v2},
      Format{"renadic", "RENADIC V1", is_renadic, read_renadic},
      Format{"bhrc", "BHRC VOL1DS", is_bhrc, read_bhrc},
      Format{"csmip-v1", "CSMIP V1", is_csmip_v1, read_csmip_v1},
      Format{"smc", "USGS SMC", is_smc, one<read_smc>},
      Format{"cwa", "CWA Taiwan", is_cwa, read_cwa},
      Format{"unam", "UNAM", is_unam, read_unam},
      Format{"peer-at2", "PEER AT2", is_peer_at2, one<read_peer_at2>, sibling_names},
      Format{"columns", "plain columns", is_columns, read_columns},
  };
  return table;
}

}  // namespace dougong::seismic
