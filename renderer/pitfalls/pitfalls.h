#pragma once
// The failures that the lab shows: each unsound value of an axis and each mistake names one of them.
namespace gbl {

enum class Pitfall {
  none,
#define PITFALL(name, ...) name,
#define MISTAKE PITFALL
#include "renderer/pitfalls/mistakes.inc"
#include "renderer/pitfalls/pitfalls.inc"
#undef MISTAKE
#undef PITFALL
};

const char* id_of(Pitfall);  // "" of none

}  // namespace gbl
