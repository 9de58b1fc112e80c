// Memory of searches, kept from one plan to the next.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace waywright {

/// Memory of searches, handed out to one plan after another.
template <class Search>
class SearchPool {
 public:
  class Lent {
   public:
    explicit Lent(SearchPool& pool) : pool_{pool} {
      const std::lock_guard lock{pool.mutex_};
      if (pool.free_.empty()) {
        search_ = std::make_unique<Search>();
      } else {
        search_ = std::move(pool.free_.back());
        pool.free_.pop_back();
      }
    }
    ~Lent() {
      const std::lock_guard lock{pool_.mutex_};
      pool_.free_.push_back(std::move(search_));
    }
    Lent(const Lent&) = delete;
    Lent& operator=(const Lent&) = delete;
    Search& operator*() { return *search_; }

   private:
    SearchPool& pool_;
    std::unique_ptr<Search> search_;
  };
  Lent lend() { return Lent{*this}; }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Search>> free_;
};

}  // namespace waywright
