// Threads that share loops.
//
// A loop is cut into shares, and what a share does depends on its number alone, never on the thread that does
// it: results are the same to the bit for any number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace dougong::engine {

class Crew {
 public:
  /// So many threads, the caller's among them (at least 1).
  explicit Crew(std::size_t threads = 1);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// The caller's thread only.
  static Crew& alone() {
    static Crew one;
    return one;
  }

  std::size_t size() const { return others_.size() + 1; }

  /// Calls work(k) for every k < shares, once each, and returns when all are done. The work may not throw,
  /// nor share again.
  template <class Work>
  void share(std::size_t shares, Work&& work) {
    if (others_.empty() || shares < 2) {
      for (std::size_t k = 0; k < shares; ++k) work(k);
      return;
    }
    run({[](void* it, std::size_t k) { (*static_cast<std::remove_reference_t<Work>*>(it))(k); }, &work,
         shares});
  }

  /// Calls work(first, last) for the parts of a range, each of `length` or what is left.
  template <class Work>
  void share_range(std::size_t count, std::size_t length, Work&& work) {
    share((count + length - 1) / length, [&](std::size_t k) {
      work(k * length, k * length + length < count ? k * length + length : count);
    });
  }

 private:
  struct Job {
    void (*call)(void*, std::size_t) = nullptr;
    void* work = nullptr;
    std::size_t shares = 0;
  };

  void run(const Job& job);
  void do_part(std::size_t member) const;
  void serve(std::size_t member);

  Job job_;
  std::atomic<std::size_t> round_{0}, done_{0};
  std::atomic<bool> ends_{false};
  std::vector<std::thread> others_;
};

}  // namespace dougong::engine
