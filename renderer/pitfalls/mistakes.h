#pragma once
// Deliberate errors that a source makes and that are no value of an axis: each can be switched on by its id. The sound
// path never pays for them: those in shaders are compile-time. Rows: mistakes.inc.
#include <span>
#include <string_view>

namespace gbl {

enum class Mistake {
#define MISTAKE(name, ...) name,
#include "renderer/pitfalls/mistakes.inc"
#undef MISTAKE
};

enum class MistakeIn { surface, shading, pass };  // material shaders, light shaders, the order or state of passes

struct MistakeRow {
  Mistake mistake;
  const char* id;  // of the catalogue: the name in kebab-case
  const char* label;
  const char* help;    // what is wrong and what is seen
  const char* source;  // where it stands
  MistakeIn in;
};

std::span<const MistakeRow> mistakes();
const MistakeRow& row(Mistake);
Mistake mistake_by_id(std::string_view id);  // Error with the known ones

}  // namespace gbl
