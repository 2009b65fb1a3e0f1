#pragma once
// Deliberate errors that a source makes and that are no value of an axis: each can be switched on by its id. The sound
// path never pays for them: those in shaders are compile-time.
#include <span>
#include <string_view>

#include "renderer/options/settings.h"

namespace gbl {

enum class MistakeIn { surface, shading, pass };  // material shaders, light shaders, the order or state of passes

struct Mistake {
  const char* id;  // of the catalogue
  const char* label;
  const char* help;    // what is wrong and what is seen
  const char* source;  // where it stands
  MistakeIn in;
};

std::span<const Mistake> mistakes();
const Mistake& mistake(std::string_view id);  // Error with the known ones

}  // namespace gbl
