// PEER AT2 (NGA-West, NGA-West2, NGA-East and before): four header lines, then acceleration in g.
//
//   PEER STRONG MOTION DATABASE RECORD            title
//   Loma Prieta, 10/18/1989, Gilroy, 67           event, date, station, component
//   ACCELERATION TIME SERIES IN UNITS OF G        or "The units are (g)"
//   NPTS=   7999, DT=   .0050 SEC,                or "4164  0.0100  NPTS, DT", or prose
//
// No formal specification is known. The sisters of the file with velocity (.VT2, cm/s) and displacement
// (.DT2, cm) have the same header: they are recognised and refused, acceleration is needed.
#pragma once

#include <string>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_peer_at2(const FileText& text);
Record read_peer_at2(const FileText& text, const ReadOptions& options);

struct PeerAt2Sheet {
  std::string title;  // first line
  std::string event, date, station, component;
  double interval = 0.0;             // s
  std::vector<double> acceleration;  // m/s2
};

/// The bytes of an AT2 file, LF line ends.
std::string write_peer_at2(const PeerAt2Sheet& sheet);

}  // namespace dougong::seismic
