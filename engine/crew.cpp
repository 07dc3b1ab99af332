#include "engine/crew.h"

namespace dougong::engine {
namespace {

// A step's loops follow each other within microseconds: a thread looks for the next so often before it goes
// to sleep.
constexpr int looks = 4000, yields = 200;

template <class Ready>
bool comes_soon(Ready&& ready) {
  for (int i = 0; i < looks; ++i)
    if (ready()) return true;
  for (int i = 0; i < yields; ++i) {
    if (ready()) return true;
    std::this_thread::yield();
  }
  return false;
}

}  // namespace

Crew::Crew(std::size_t threads) {
  for (std::size_t member = 1; member < threads; ++member)
    others_.emplace_back([this, member] { serve(member); });
}

Crew::~Crew() {
  ends_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : others_) thread.join();
}

void Crew::do_part(std::size_t member) const {
  const std::size_t first = job_.shares * member / size(), last = job_.shares * (member + 1) / size();
  for (std::size_t k = first; k < last; ++k) job_.call(job_.work, k);
}

void Crew::run(const Job& job) {
  job_ = job;
  done_ = 0;
  ++round_;
  round_.notify_all();
  do_part(0);
  while (!comes_soon([this] { return done_ == others_.size(); })) {
  }
}

void Crew::serve(std::size_t member) {
  for (std::size_t seen = 0;; ++seen) {
    if (!comes_soon([&] { return round_ != seen; })) round_.wait(seen);
    if (ends_) return;
    do_part(member);
    ++done_;
  }
}

}  // namespace dougong::engine
