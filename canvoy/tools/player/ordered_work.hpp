// Independent tasks on several threads, with results in order: the output is the same for any
// number of threads.
//
//     in_order<Report>(200, 8, [](std::size_t i) { return report(i); }, print);
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace canvoy::tools {

template <class Result>
class OrderedWork {
 public:
  using Work = std::function<Result(std::size_t)>;
  using Take = std::function<void(Result)>;

  OrderedWork(std::size_t count, Work work) : work_(std::move(work)), results_(count) {}

  /// Uses up to `threads` threads, or the calling one if the system provides none. An exception of
  /// `work` or `take` ends all, and is thrown here.
  void run(unsigned threads, const Take& take) {
    std::vector<std::jthread> workers;
    start(workers, threads);
    const Ending ending{*this};  // before waiting for the workers
    if (workers.empty()) do_work();
    for (std::size_t i = 0; i < results_.size(); ++i) take(wait_for(i));
  }

 private:
  struct Ending {
    ~Ending() { work.next_ = work.results_.size(); }
    OrderedWork& work;
  };

  void start(std::vector<std::jthread>& workers, unsigned threads) {
    const std::size_t wanted = std::min<std::size_t>(threads, results_.size());
    try {
      while (workers.size() < wanted) workers.emplace_back([this] { do_work(); });
    } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): fewer do it as well
    }
  }

  void do_work() {
    for (std::size_t i = 0; (i = next_++) < results_.size();) {
      try {
        Result result = work_(i);
        const std::lock_guard lock(mutex_);
        results_[i] = std::move(result);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
      }
      has_news_.notify_one();
    }
  }

  Result wait_for(std::size_t i) {
    std::unique_lock lock(mutex_);
    std::optional<Result>& result = results_[i];
    has_news_.wait(lock, [&] { return failure_ != nullptr || result.has_value(); });
    if (!result) std::rethrow_exception(failure_);
    return *std::move(result);
  }

  Work work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;  ///< protects the members below
  std::condition_variable has_news_;
  std::vector<std::optional<Result>> results_;
  std::exception_ptr failure_;
};

/// Calls `work` with 0 to `count` - 1 on up to `threads` threads, and `take` with each result on
/// the calling one, in order.
template <class Result>
void in_order(std::size_t count, unsigned threads, typename OrderedWork<Result>::Work work,
              const typename OrderedWork<Result>::Take& take) {
  OrderedWork<Result>(count, std::move(work)).run(threads, take);
}

}  // namespace canvoy::tools
