// Damaged copies of a file, for readers that must refuse them and never fall over: seeded, so that a failure
// comes again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

namespace dougong::seismic::testing {

class Mutations {
 public:
  explicit Mutations(unsigned seed) : random_(seed) {}

  /// One to four changes: bytes flipped, cut out, doubled or written over; numbers made absurd; the end cut
  /// off.
  std::string damaged(std::string bytes) {
    for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t bound) {
    return static_cast<std::size_t>(random_()) % std::max<std::size_t>(bound, 1);
  }

  // Headers decide more than data do: half of the places are among the first bytes.
  std::size_t place_in(const std::string& bytes) {
    return below(below(2) ? bytes.size() : std::min<std::size_t>(bytes.size(), 2000));
  }

  void change(std::string& bytes) {
    static constexpr std::array<std::string_view, 16> absurd = {
        "99999999999", "-1",       "nan",  "1e308", "-0", "0", "1e-320",    "4294967297",
        ".",           "\xff\xfe", "\n\n", "\r",    "(",  ":", "(9999F99)", "              "};
    const std::size_t at = place_in(bytes), length = std::min(1 + below(40), bytes.size() - at);
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random_());
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 3: {
        const std::string_view word = absurd[below(absurd.size())];
        bytes.replace(at, std::min(word.size(), bytes.size() - at), word);
        break;
      }
      case 4:
        write_over_a_number(bytes, at);
        break;
      default:
        bytes.resize(at);
        break;
    }
  }

  void write_over_a_number(std::string& bytes, std::size_t at) {
    at = bytes.find_first_of("0123456789", at);
    if (at == std::string::npos) return;
    const std::size_t end = std::min(bytes.find_first_not_of("0123456789", at), bytes.size());
    for (std::size_t i = at; i < end; ++i) bytes[i] = static_cast<char>('0' + below(10));
  }

  std::mt19937 random_;
};

}  // namespace dougong::seismic::testing
