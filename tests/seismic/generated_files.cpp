#include "tests/seismic/generated_files.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "seismic/formats/csmnc.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/miniseed.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/formats/record_csv.h"

namespace dougong::seismic::testing {
namespace {

constexpr double gal = 0.01;  // m/s2
constexpr double interval = 0.01;

using Value = std::function<double(std::size_t)>;  // of sample k, in the file's units

Value in(double unit) {
  return [unit](std::size_t k) { return sample(k) / unit; };
}

std::vector<double> motion() {
  std::vector<double> out;
  for (std::size_t k = 0; k < samples; ++k) out.push_back(sample(k));
  return out;
}

// A number as Fortran's F fields hold it: without the zero before the point when there is no room.
std::string fixed(double value, std::size_t width, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.size() > width && text.starts_with("0.")) text.erase(0, 1);
  if (text.size() > width && text.starts_with("-0.")) text.erase(1, 1);
  return fmt::format("{:>{}}", text, width);
}

std::string rows(std::size_t count, std::size_t per_line,
                 const std::function<std::string(std::size_t)>& field) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i)
    out += field(i) + (i % per_line == per_line - 1 || i + 1 == count ? "\n" : "");
  return out;
}

std::string block(std::size_t per_line, std::size_t width, int decimals, const Value& value) {
  return rows(samples, per_line, [&](std::size_t k) { return fixed(value(k), width, decimals); });
}

// Time and value, `indent` columns before the first of a line.
std::string pairs(std::size_t pairs_a_line, std::size_t width, int decimals, const Value& value,
                  const std::string& indent = "", double first_time = 0.0) {
  std::string out;
  for (std::size_t k = 0; k < samples; ++k) {
    if (k % pairs_a_line == 0) out += indent;
    out += fixed(first_time + interval * static_cast<double>(k), width, 3) + fixed(value(k), width, decimals);
    if (k % pairs_a_line == pairs_a_line - 1 || k + 1 == samples) out += '\n';
  }
  return out;
}

std::string integers(
    std::size_t count, std::size_t per_line, std::size_t width,
    const std::function<long(std::size_t)>& value = [](std::size_t) { return 0L; }) {
  return rows(count, per_line, [&](std::size_t i) { return fmt::format("{:>{}}", value(i), width); });
}

std::string reals(
    std::size_t count, std::size_t per_line, std::size_t width, int decimals,
    const std::function<double(std::size_t)>& value = [](std::size_t) { return 0.0; }) {
  return rows(count, per_line, [&](std::size_t i) { return fixed(value(i), width, decimals); });
}

ReadOptions in_units(const char* units) {
  ReadOptions options;
  options.units = units;
  return options;
}

}  // namespace

double sample(std::size_t k) {
  const double n = static_cast<double>(k);
  if (k > 100) return 0.4 * std::sin(0.37 * n) + 0.3 * std::sin(1.7 * n);
  if (k == 5) return 1.0;
  return 0.7 * std::exp(-n / 7.0) * std::sin(0.9 * n);
}

GeneratedFile at2_file() {
  return {"peer-at2",
          write_peer_at2({"PEER NGA STRONG MOTION DATABASE RECORD", "Made", "1/2/2003", "Nowhere", "N08W",
                          interval, motion()}),
          {},
          {"N08W"},
          interval,
          1e-6};
}

GeneratedFile knet_file() {
  KnetSheet sheet;
  sheet.origin_time = "2018/01/24 19:51:00";
  sheet.record_time = "2018/01/24 19:51:43";
  sheet.latitude = "41.0", sheet.longitude = "142.5", sheet.depth = "30", sheet.magnitude = "6.2";
  sheet.station_code = "AOM001", sheet.station_latitude = "41.5267", sheet.station_longitude = "140.9244";
  sheet.station_height = "39", sheet.direction = "E-W";
  sheet.scale_gal = 3920, sheet.scale_counts = 6182761;
  const double count = 3920.0 / 6182761 * gal;
  for (const double a : motion()) sheet.counts.push_back(10190 + std::lround(a / count));
  return {"knet", write_knet(sheet), {}, {"EW"}, interval, count, true};
}

namespace {

std::string nied_csv(const std::string& heights, const std::string& titles, std::size_t components) {
  std::string out = "#K-NET CSV\n#Event\n#OriginTime,Latitude,Longitude,Depth(km),Magnitude\n";
  out += "#2019/01/02 17:47:00,36.708,140.952,32,3.8\n#Station\n#Code,Latitude,Longitude,Height(m)\n";
  out += "#FKS005,37.6389,140.9853," + heights +
         "\n#Record\n#SamplingFrequency(Hz)\n#100\n#DurationTime(s)\n#" +
         fmt::format("{}\n", interval * static_cast<double>(samples));
  out += "#Offset\n#" + titles + "\n#0\n#Time,RelativeTime(s)," + titles + "\n";
  for (std::size_t k = 0; k < samples; ++k) {
    const double t = interval * static_cast<double>(k);
    out += fmt::format("2019/01/02 17:47:{:05.2f},{:.2f}", 27.0 + t, t);
    for (std::size_t c = 0; c < components; ++c)
      out += fmt::format(",{:.2f}", sample(k) / gal + 7.0 * static_cast<double>(c));
    out += '\n';
  }
  return out;
}

}  // namespace

GeneratedFile knet_csv_file() {
  return {"knet-csv", nied_csv("17", "N-S(gal),E-W(gal),U-D(gal)", 3), {}, {"NS", "EW", "UD"}, interval, 1e-4,
          true};
}

GeneratedFile kiknet_csv_file() {
  return {"knet-csv", nied_csv("60,260", "1(gal),2(gal),3(gal),4(gal),5(gal),6(gal)", 6),
          {},         {"NS1", "EW1", "UD1", "NS2", "EW2", "UD2"},
          interval,   1e-4,
          true};
}

namespace {

Record record_of(const char* component) {
  Record record;
  record.acceleration = motion();
  record.interval = interval;
  record.component = component;
  record.azimuth = 90.0;
  record.provenance.station = "51BXD";
  record.provenance.event = "MADE";
  record.provenance.start_time = "2013-04-20T08:02:46.000+08:00";
  return record;
}

}  // namespace

GeneratedFile csmnc_file() {
  return {"csmnc", write_csmnc(record_of("EW")), {}, {"EW"}, interval, 1e-6};
}

GeneratedFile rec_file() {
  std::string out = "\xD5\xF0\xBC\xB6\t\xC4\xEA\r\n7.0\t2001\tMade\tNowhere\tEW\r\n";
  for (std::size_t k = 0; k < samples; ++k)
    out += fmt::format("{:.2E}\t{:.6E}\r\n", interval * static_cast<double>(k), sample(k));
  return {"rec", out, {}, {"EW"}, interval, 1e-6, false, true};
}

GeneratedFile dyna_file() {
  std::string out = "EVENT_NAME: MADE: twice\nEVENT_DATE_YYYYMMDD: 20190728\nEVENT_LATITUDE_DEGREE: 38.1\n";
  out += "EVENT_LONGITUDE_DEGREE: 23.54\nEVENT_DEPTH_KM: 9.0\nMAGNITUDE_W: \nMAGNITUDE_L: 4.6\nNETWORK: HI\n";
  out += "STATION_CODE: ARS1\nSTATION_LATITUDE_DEGREE: 37.6349\nSTATION_LONGITUDE_DEGREE: 22.7293\n";
  out += "STATION_ELEVATION_M: 34\nDATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20190728_160919.870\n";
  out += fmt::format("SAMPLING_INTERVAL_S: 0.010000\nNDATA: {}\nSTREAM: HNE\nUNITS: cm/s^2\n", samples);
  out += "PGA_CM/S^2: 100.000000\nFILTER_TYPE: BUTTERWORTH\nFILTER_ORDER: 2\nLOW_CUT_FREQUENCY_HZ: 0.1\n";
  out += "HIGH_CUT_FREQUENCY_HZ: 30\nDATA_TYPE: ACCELERATION\nUSER1: a: b\nUSER5: \n";
  for (std::size_t k = 0; k < samples; ++k) out += fmt::format("{:.6f}\n", sample(k) / gal);
  return {"dyna", out, {}, {"HNE"}, interval, 1e-8};
}

GeneratedFile nsmn_file() {
  std::string out =
      "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : MU\xD0LA GULLUK\r\n";
  out +=
      "EARTHQUAKE DATE         : 2017/07/20 22:31:09 (GMT)\r\nEPICENTER COORDINATES   : "
      "36.91980N-27.44350E\r\n";
  out += "EARTHQUAKE MAGNITUDE    : 6.5 Mw\r\nSTATION ID              : 4817\r\n";
  out += "STATION COORDINATES     : 37.24010N-27.60310E\r\nSTATION ALTITUDE (m)    : 10\r\n";
  out += "RECORD TIME             : 20/07/2017 22:30:59.000000 (GMT)\r\n";
  out += fmt::format("NUMBER OF DATA          : {}\r\nSAMPLING INTERVAL (sec) : 0.01\r\n", samples);
  out += "       N-S          E-W          U-D\r\n";
  for (std::size_t k = 0; k < samples; ++k)
    out += fmt::format("{0:12.6f} {0:12.6f} {0:12.6f}\r\n", sample(k) / gal);
  return {"nsmn", out, {}, {"N-S", "E-W", "U-D"}, interval, 1e-8};
}

namespace {

std::string volume_1_header(const std::string& first, const std::string& station,
                            const std::string& component) {
  std::string out =
      first + "\nMADE EARTHQUAKE\nJANUARY 17, 1994 04:31 PST\nID   TRIGGER TIME: 01/17/94, 12:31:04.1 UTC\n";
  out +=
      station + "\nSOMEWHERE\n" + component + "\nMADE EARTHQUAKE\nHYPOCENTER: 34.215N, 118.538W, H=18KM.\n";
  out += "INSTR PERIOD =  .0397 SEC,  DAMPING =  .592\n";
  out += fmt::format("NO. OF POINTS = {:6}  DURATION = 1.01 SEC\n", samples);
  return out + "UNITS ARE SEC AND G/10\nRMS ACCEL OF COMPLETE RECORD =  .021 G.\n";
}

std::string film_numbers() {
  return integers(100, 16, 5, [](std::size_t i) { return i == 26   ? 90L
                                                         : i == 27 ? 11999L
                                                                   : 0L; }) +
         reals(50, 8, 10, 3);
}

constexpr double tenth_of_g = 0.980665;

}  // namespace

GeneratedFile csmip_v1_file() {
  std::string out;
  // Beyond 100 s the fields of the times touch those of the values before them.
  for (const auto& [component, start] : {std::pair{"CHAN  1:  90 DEG", 0.0}, std::pair{"CHAN  2: UP", 99.5}})
    out += volume_1_header("UNCORRECTED ACCELEROGRAM DATA    PROCESSED: 02/08/94, CDMG",
                           "STATION NO. 14403   33.929N, 118.260W     SMA-1  S/N 3492", component) +
           film_numbers() + pairs(5, 7, 3, in(tenth_of_g), "", start) + "/&  ----------  END OF DATA\n";
  return {"csmip-v1", out, {}, {"90", "UP"}, interval, 1e-3, false, true};
}

GeneratedFile csmip_v2_file(bool stated_format) {
  std::string out;
  for (const char* component : {"Chan  1:  90 Deg", "Chan  2:  Up"}) {
    out +=
        "Corrected accelerogram   58667-L2866\nUncorrected Accelerogram Data\nRcrd of Sun Aug 24, 2014 "
        "03:20:33.0 PDT\n";
    out +=
        "Start time:  8/24/14, 10:20:33.0 UTC (GPS)\nStation No. 58667   37.973N, 122.038W    Etna    s/n "
        "2866\n";
    out += fmt::format("{}\nAccelerogram bandpass filtered with 3 dB pts at   .07 and 40.00 cyc/sec\n",
                       component);
    out += fmt::format("  {} points of instrument- and baseline-corrected accel, veloc and displ data\n",
                       samples);
    out += "Peak acceleration =   100.000     cm/sec/sec  at    0.05   sec.\n";
    for (int line = 9; line < 25; ++line) out += "-\n";
    out += integers(100, 16, 5, [](std::size_t i) { return i == 26 ? 11001L : 5000L; });
    out += reals(100, 8, 10, 5, [](std::size_t i) { return i % 3 ? 1000.5 : -999.0; });
    const auto title = [&](const char* quantity, const char* unit, const char* format) {
      return stated_format
                 ? fmt::format("  {} points of {} data equally spaced at  .010 sec, in {}. {}\n", samples,
                               quantity, unit, format)
                 : fmt::format("  {} POINTS OF {} DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n",
                               samples, quantity);
    };
    out += title("accel", "cm/sec2", "(8f10.6)") + block(8, 10, 6, in(gal));
    out += title("veloc", "cm/sec", "(8f10.7)") + block(8, 10, 6, in(1.0));
    out += title("displ", "cm", "(8f10.7)") + block(8, 10, 6, in(1.0));
    out += "/&  ----------  End of data\n";
  }
  return {"csmip-v2", out, {}, {"90", "Up"}, interval, 1e-8};
}

GeneratedFile usc_v1_file() {
  const std::string out = volume_1_header("FILE 0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I",
                                          "STATION USC# 0061   34 17 11N, 118 13 31W", "COMP N08W") +
                          film_numbers() + pairs(5, 7, 3, in(tenth_of_g), " ") + "\n";
  return {"usc", out, {}, {"N08W"}, interval, 1e-3, false, true};
}

GeneratedFile usc_v2_file() {
  std::string out =
      "CORRECTED ACCELEROGRAM  IIBB127  94.610.0 COMP N08W\nFILE 0 OF UNCORRECTED ACCELEROGRAM DATA\n";
  out += "NORTHRIDGE EARTHQUAKE\nSTATION USC# 0061   34 17 11N, 118 13 31W\nCOMP N08W\n";
  out += "ACCELEROGRAM IS BAND-PASS FILTERED BETWEEN  .225- .325 AND 25.00-27.00 HZ.\n";
  out += "PEAK ACCELERATION =  -100.00000  CMS/SEC/SEC AT    0.050   SEC.\nIIBB127  COMP N08\nW\n";
  out += integers(100, 16, 5) + reals(100, 8, 10, 3);
  for (const char* quantity : {"ACC", "VEL", "DIS"})
    out += fmt::format("  {} POINTS OF {} DATA EQUALLY SPACED AT   .010 SEC.  IN UNITS CM/SEC/SEC\n", samples,
                       quantity) +
           block(8, 10, 3, in(gal));
  return {"usc", out, {}, {"N08W"}, interval, 1e-5};
}

GeneratedFile renadic_file() {
  std::string out =
      "UNCORRECTED ACCELEROGRAM DATA PROCESSED: 03/01/2010\nMAULE EARTHQUAKE\nFEBRUARY 27, 2010\n";
  out +=
      "ID   TRIGGER TIME: 2/27/2010 6:35:46.000 GMT\nSTATION  0.000S, 0.000W\nVI\xD1"
      "A DEL MAR CENTRO  S/N 675\n";
  out += "COMP NS\nUNIVERSIDAD DE CHILE - RENADIC\nMAULE\nINSTR PERIOD = .02 SEC, DAMPING = .6\n";
  out += fmt::format("NO. OF POINTS = {} DURATION = 1.00 SEC\nUNITS ARE SEC AND G/10\n-\n", samples);
  out += integers(100, 16, 5) + reals(50, 8, 10, 3) + pairs(5, 7, 4, in(tenth_of_g)) + "/&\n";
  return {"renadic", out, {}, {"NS"}, interval, 1e-4, false, true};
}

GeneratedFile bhrc_file() {
  std::string out;
  for (const char* component : {"COMP L1", "COMP V2", "COMP T3"}) {
    out += "* VOL1DS FILE:  5529/01\nInst Type = SSA-2\nOrigin Time : 2012/08/11   12:23:16\n\nL\n\n";
    out += fmt::format("{}\nBand      Station   37.498 N 44.999 E   Altitude 1417m   Azimuth L 106   T 196\n",
                       component);
    out += "Epicenter 38.520 N 46.860 E   FD 12 Km\nINSTR PERIOD =  .019 SEC\n";
    out += fmt::format("NO. OF POINTS =   {}      DURATION =  {:.3f}\nUNITS ARE SECONDS AND G/10\n\n",
                       samples, interval * static_cast<double>(samples));
    out += integers(100, 16, 5) + reals(50, 8, 14, 6);
    out += rows(samples, 10, [](std::size_t k) { return fmt::format("{:13.5E}", sample(k) / tenth_of_g); });
    out += "/&\n";
  }
  return {"bhrc", out, {}, {"L1", "V2", "T3"}, interval, 1e-5};
}

namespace {

std::string cosmos_channel(const std::string& first, long unit, const std::string& channel, double peak,
                           const std::string& title, const std::string& data) {
  std::string out = first + "  (Format v01.20 with 13 text lines)\nRecord of Made Earthquake\n";
  for (int line = 2; line < 7; ++line) out += "-\n";
  out +=
      "Rcrd start time: 2018/11/30 17:29:39.137 UTC (Q=5) RcrdId: (see comment)\nSta Chan   1: 90 "
      "Deg\n-\n-\n";
  out += "Record filtered below  0.03 Hz\nunknown:   -999, -999.00\n";
  out += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n";
  out += integers(100, 10, 8, [&](std::size_t i) { return i == 1 ? 1L : i == 2 ? unit : -999L; });
  out += " 100 Real-header values follow on  20 lines, Format =(5F15.6)\n";
  out += reals(100, 5, 15, 6, [&](std::size_t i) {
    return i == 0    ? 60.9677
           : i == 1  ? -144.6051
           : i == 2  ? 842.0
           : i == 33 ? 0.02
           : i == 61 ? 10.0
           : i == 63 ? peak
                     : -999.0;
  });
  out += "   2 Comment line(s) follow, each starting with a \"|\":\n | made\n|<SCNL>BMR." + channel +
         ".AK.-- <AUTH>\n";
  return out + title + "\n" + data + "End-of-data for Chan " + channel + " acceleration\n";
}

}  // namespace

GeneratedFile cosmos_v0_file() {
  const double count = 1e-5;
  std::string out;
  for (const char* channel : {"HNE", "HNZ"})
    out += cosmos_channel(
        "Raw acceleration counts", 50, channel, 1e5,
        fmt::format("   {} raw accel.   pts, approx  1 secs, units=counts (50),Format=(10I8)", samples),
        rows(samples, 10,
             [&](std::size_t k) { return fmt::format("{:8d}", 10190 + std::lround(sample(k) / count)); }));
  GeneratedFile file{"cosmos", out, {}, {"HNE", "HNZ"}, interval, count, true};
  file.options.count_scale = count;
  return file;
}

GeneratedFile cosmos_v1_file() {
  const double g = standard_gravity;
  return {"cosmos",
          cosmos_channel(
              "Uncorrected acceleration", 2, "HNE", 1 / g,
              fmt::format("   {} acceleration pts, approx 1 secs, units = g (02), Format = (8f9.6)", samples),
              block(8, 9, 6, in(g))),
          {},
          {"HNE"},
          interval,
          1e-5};
}

GeneratedFile cosmos_v2_file() {
  return {"cosmos",
          cosmos_channel(
              "Corrected acceleration", 4, "HNE", 100,
              fmt::format("   {} acceleration pts, approx 1 secs, units=cm/sec2(04),Format=(E15.6)", samples),
              rows(samples, 1, [](std::size_t k) { return fmt::format("{:15.6e}", sample(k) / gal); })),
          {},
          {"HNE"},
          interval,
          1e-6};
}

namespace {

GeneratedFile geonet_file(bool corrected) {
  std::string out;
  for (const char* component : {"S16W", "S74E", "Up"}) {
    out += fmt::format("{} accelerogram 20180212_211554_WPWS_20 GNS Science\n",
                       corrected ? "Corrected" : "Uncorrected");
    out +=
        "Site WPWS      39 56 38S  176 35 04E\nMade\nInstrument\n24-bit\n-\n6 km south\n2018 February "
        "12\n-\n-\n-\n";
    out += fmt::format(
        "Band-pass\nComponent {}  Axis\nAcceleration:  peak 1000.0 mm/s/s at  43.68 sec\n-\n-\n", component);
    const long n = static_cast<long>(samples);
    out += integers(40, 10, 8, [&](std::size_t i) {
      const long stated[] = {n, 0, 0, n, n, n};
      const long start[] = {2018, 2, 12, 21, 15, 17000};
      return i == 8              ? start[0]
             : i == 9            ? start[1]
             : i == 18           ? start[2]
             : i == 19           ? start[3]
             : i == 38           ? start[4]
             : i == 39           ? start[5]
             : i >= 30 && i < 36 ? stated[i - 30]
                                 : 0L;
    });
    out += reals(60, 10, 8, 3, [](std::size_t i) {
      return i == 10 ? 39.944 : i == 11 ? 176.584 : i == 25 ? 0.01 : 0.0;
    });
    for (int quantity = 0; quantity < (corrected ? 3 : 1); ++quantity) out += block(10, 8, 1, in(1e-3));
  }
  return {"geonet", out, {}, {"S16W", "S74E", "Up"}, interval, 1e-4};
}

}  // namespace

GeneratedFile geonet_v1_file() {
  return geonet_file(false);
}

GeneratedFile geonet_v2_file() {
  return geonet_file(true);
}

namespace {

std::string smc_header(int type, std::size_t values, double rate) {
  std::string out = fmt::format("{} {}\n*\nSAF0A\n     1989  10  18    0004 Made\n-\n", type,
                                type == 1 ? "UNCORRECTED ACCELEROGRAM" : "CORRECTED ACCELEROGRAM");
  out +=
      "station = San Francisco, 1295 Shafter, F component=    360\nepicentral dist = 89.0  pk     =    "
      "100.0\n";
  out += "inst type=SMA-1\n*\n*\n*\n";
  out += integers(48, 8, 10, [&](std::size_t i) {
    const long stated[] = {-32768, 1989, 291, 0, 4, 0, -32768};
    return i < 7 ? stated[i] : i == 15 ? 1L : i == 16 ? static_cast<long>(values) : -32768L;
  });
  out += rows(50, 5, [&](std::size_t i) {
    return fmt::format("{:15.7E}", i == 1 ? rate : i == 10 ? 37.728 : i == 11 ? -122.385 : 0.17e39);
  });
  return out + "| a comment\n";
}

// " 1.5057E+0": ten columns, the exponent of one digit.
std::string smc_field(double value) {
  const int exponent = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-12));
  return fmt::format("{:7.4f}E{}{}", value / std::pow(10.0, exponent), exponent < 0 ? '-' : '+',
                     std::abs(exponent));
}

}  // namespace

GeneratedFile smc_file(int type, bool narrow) {
  const auto field = [narrow](std::size_t k) {
    return narrow ? smc_field(sample(k) / gal) : fmt::format("{:14.6E}", sample(k) / gal);
  };
  return {"smc",    smc_header(type, samples, 100.0) + rows(samples, narrow ? 8 : 1, field),
          {},       {"360"},
          interval, 1e-4};
}

GeneratedFile smc_pairs_file(bool even) {
  const auto time = [even](std::size_t k) {
    return interval * (static_cast<double>(k) + (even || k % 3 != 1 ? 0.0 : 0.5));
  };
  const std::string data = rows(
      2 * samples, 8, [&](std::size_t i) { return smc_field(i % 2 ? sample(i / 2) / gal : time(i / 2)); });
  return {"smc", smc_header(1, 2 * samples, 0.17e39) + data, {}, {"360"}, interval, 1e-4, false, true};
}

GeneratedFile cwa_file() {
  std::string out =
      "#Earthquake Information\r\n#Origin Time(GMT+08): 2018/02/06-23:50:42\r\n#EpicenterLongitude(E): "
      "121.69\r\n";
  out +=
      "#EpicenterLatitude(N): 24.14\r\n#Depth(km): 10.0\r\n#Magnitude(Ml): 6.0\r\n\r\n#Station "
      "Information\r\n";
  out += "#StationCode: ECU\r\n#StationLongitude(E): 121.092\r\n#StationLatitude(N): 22.860\r\n";
  out += "#StartTime(GMT+08): 2018/02/06-23:50:29.000\r\n#RecordLength(sec): " +
         fmt::format("{}\r\n#SampleRate(Hz): 100\r\n", interval * static_cast<double>(samples));
  out += "#AmplitudeUnit:  gal. DCoffset(corr)\r\n#AmplitudeMAX. U:  100.000~   -60.017\r\n";
  out += "#DataSequence: Time U(+); N(+); E(+)\r\n#Data: 4F10.3 \r\n";
  for (std::size_t k = 0; k < samples; ++k)
    out += fmt::format("{0:10.3f}{1:10.3f}{1:10.3f}{1:10.3f}\r\n", interval * static_cast<double>(k),
                       sample(k) / gal);
  return {"cwa", out, {}, {"U", "N", "E"}, interval, 1e-5};
}

GeneratedFile unam_file() {
  std::string out = "****\r\nINSTITUTO DE INGENIERIA, UNAM\r\nARCHIVO ESTANDAR DE ACELERACION:\r\n";
  out +=
      "CLAVE DE LA ESTACION                   : CUP5\r\nCOORDENADAS DE LA ESTACION             : 19.33024 "
      "LAT. N\r\n";
  out += "                                       : 99.181076 LONG. W\r\n";
  out += "VEL. DE MUESTREO, C1-C6 (muestras/s)   : /100/100/100\r\n";
  out +=
      "NUM. TOTAL DE MUESTRAS, C1-C6          : /99/99/99\r\nACEL. MAX.(Gal), C1-C6                 : "
      "/100.0/100.0/-100.0\r\n";
  out +=
      "UNIDADES DE LOS DATOS                  : Gal (cm/s/s)\r\nFORMATO DATOS (FORTRAN,10 campos/dato) : "
      "3F10.3\r\n";
  out += "   CANAL-1   CANAL-2   CANAL-3\r\n         V      N90E      N00E\r\n---------+\r\n";
  for (std::size_t k = 0; k < samples; ++k)
    out += fmt::format("{0:10.3f}{0:10.3f}{0:10.3f}\r\n", sample(k) / gal);
  return {"unam", out, {}, {"V", "N90E", "N00E"}, interval, 1e-5};
}

GeneratedFile sac_file(bool big_endian) {
  std::string bytes(632, '\0');
  const auto put = [&](std::size_t at, auto value) {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, 4);
    if (big_endian) word = __builtin_bswap32(word);
    std::memcpy(bytes.data() + at, &word, 4);
  };
  for (std::size_t i = 0; i < 70; ++i) put(4 * i, -12345.0f);
  for (std::size_t i = 0; i < 40; ++i) put(280 + 4 * i, std::int32_t{-12345});
  for (std::size_t i = 0; i < 24; ++i) bytes.replace(440 + 8 * i, 8, "-12345  ");
  put(0, 0.01f), put(4 * 5, 0.5f), put(4 * 31, 34.0f), put(4 * 32, -118.0f), put(4 * 57, 90.0f);
  const std::int32_t start[] = {2019, 187, 3, 19, 52, 250};
  for (std::size_t i = 0; i < 6; ++i) put(280 + 4 * i, start[i]);
  put(280 + 4 * 6, std::int32_t{6}), put(280 + 4 * 9, static_cast<std::int32_t>(samples));
  put(280 + 4 * 15, std::int32_t{1}), put(280 + 4 * 35, std::int32_t{1});
  bytes.replace(440, 8, "T001230 "), bytes.replace(440 + 160, 8, "HNE     "),
      bytes.replace(440 + 168, 8, "CJ      ");
  bytes.resize(632 + 4 * samples);
  for (std::size_t k = 0; k < samples; ++k) put(632 + 4 * k, static_cast<float>(sample(k)));
  return {"sac", bytes, in_units("m/s2"), {"HNE"}, interval, 1e-6};
}

GeneratedFile miniseed_file() {
  const MiniseedChannel channels[] = {
      {"CI", "CLC", "", "HNE", "2019-07-06T03:19:23.038", interval, motion()},
      {"CI", "CLC", "", "HNZ", "2019-07-06T03:19:23.038", interval, motion()}};
  return {"miniseed", write_miniseed(channels), in_units("m/s2"), {"HNE", "HNZ"}, interval, 1e-15};
}

GeneratedFile record_csv_file() {
  const Record components[] = {record_of("EW"), record_of("NS")};
  return {"record-csv", write_record_csv(components), {}, {"EW", "NS"}, interval, 1e-15};
}

GeneratedFile columns_file() {
  std::string out = "Made\nTime[s] EW NS\n";
  for (std::size_t k = 0; k < samples; ++k)
    out += fmt::format("{0:.2f}\t{1:.6f}\t{1:.6f}\n", interval * static_cast<double>(k), sample(k));
  return {"columns", out, in_units("m/s2"), {"EW", "NS"}, interval, 1e-6, false, true};
}

std::vector<GeneratedFile> generated_files() {
  return {at2_file(),       knet_file(),         knet_csv_file(),      kiknet_csv_file(),
          csmnc_file(),     rec_file(),          dyna_file(),          nsmn_file(),
          csmip_v1_file(),  csmip_v2_file(true), csmip_v2_file(false), usc_v1_file(),
          usc_v2_file(),    renadic_file(),      bhrc_file(),          cosmos_v0_file(),
          cosmos_v1_file(), cosmos_v2_file(),    geonet_v1_file(),     geonet_v2_file(),
          smc_file(0),      smc_file(2),         smc_file(2, false),   smc_pairs_file(true),
          cwa_file(),       unam_file(),         sac_file(false),      sac_file(true),
          miniseed_file(),  record_csv_file(),   columns_file()};
}

}  // namespace dougong::seismic::testing
