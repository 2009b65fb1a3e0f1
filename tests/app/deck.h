#pragma once
// Cards in a random order, seeded: all are dealt before one comes again.
#include <utility>
#include <vector>

#include "renderer/base/random.h"

namespace gbl::test {

template <class T>
class Deck {
 public:
  explicit Deck(std::vector<T> cards) : cards_(std::move(cards)), next_(cards_.size()) {}

  const T& top(Pcg32& random) {
    if (next_ == cards_.size()) shuffle(random);
    return cards_[next_];
  }
  void take() { rounds_ += ++next_ == cards_.size(); }
  // The top card does not fit now: it comes last of this round.
  void put_below() { std::swap(cards_[next_], cards_.back()); }
  const T& deal(Pcg32& random) {
    const T& card = top(random);
    take();
    return card;
  }
  int rounds() const { return rounds_; }  // in which all were dealt

 private:
  void shuffle(Pcg32& random) {
    for (size_t k = cards_.size(); k > 1; --k) std::swap(cards_[k - 1], cards_[random.next() % k]);
    next_ = 0;
  }
  std::vector<T> cards_;
  size_t next_;
  int rounds_ = 0;
};

}  // namespace gbl::test
