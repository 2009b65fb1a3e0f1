#pragma once
// PCG32 (O'Neill 2014, "PCG: A family of simple fast space-efficient statistically good algorithms for random
// number generation"). Integers first, then double, one rounding: equal seeds give equal numbers on every machine. That holds only
// where no two are drawn among the arguments of one call: in which order those are worked out is the compiler's choice.
#include <cstdint>

namespace gbl {

class Pcg32 {
 public:
  explicit Pcg32(uint64_t seed, uint64_t stream = 1) : increment_((stream << 1) | 1) {
    next();
    state_ += seed;
    next();
  }
  uint32_t next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<uint32_t>(old >> 59);
    return (shifted >> turn) | (shifted << ((32 - turn) & 31));
  }
  double unit() { return next() * 0x1p-32; }  // [0, 1)
  double in(double low, double high) { return low + (high - low) * unit(); }

 private:
  uint64_t state_ = 0, increment_;
};

}  // namespace gbl
