// Simpson's rule: the oracles' only numerical integration.
#pragma once

namespace dougong::oracles {

template <class F>
double integral(F f, double from, double to, int intervals = 2000) {
  const double h = (to - from) / intervals;
  double sum = f(from) + f(to);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(from + i * h);
  return sum * h / 3.0;
}

}  // namespace dougong::oracles
