#include <array>

#include "seismic/formats/columns.h"
#include "seismic/formats/csmnc.h"
#include "seismic/formats/format.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/formats/rec_shape.h"

namespace dougong::seismic {

std::span<const Format> formats() {
  static constexpr std::array table = {
      Format{"peer-at2", "PEER AT2", is_peer_at2, read_peer_at2, nullptr},
      Format{"knet", "K-NET/KiK-net ASCII", is_knet, read_knet, knet_siblings},
      Format{"csmnc", "CSMNC uncorrected", is_csmnc, read_csmnc, nullptr},
      Format{"rec", "normalised .rec shape", is_rec_shape, read_rec_shape, nullptr},
      Format{"columns", "plain columns", is_columns, read_columns, nullptr},
  };
  return table;
}

}  // namespace dougong::seismic
