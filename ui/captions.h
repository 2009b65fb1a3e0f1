#pragma once
// What a key or a widget changed, in words: what it is now, what that does, what it costs and whether it is sound.
// Built from the tables' rows, so that a new row speaks for itself.
#include <string>
#include <string_view>

#include "renderer/options/options.h"

namespace gbl::ui {

struct Sentence {
  std::string text;     // empty: nothing changed
  std::string pitfall;  // of the value chosen now; empty = sound
  // "… UNSOUND: backface-cull-inside."
  std::string whole() const { return pitfall.empty() ? text : text + " UNSOUND: " + pitfall + "."; }
};

// The difference between two settings; the camera, the time and the main view speak through their pictures.
Sentence describe_change(const Settings& before, const Settings& after);

// One option's step, also when there was nowhere to go.
Sentence describe_step(const Option&, const Settings& before, const Settings& after);

// A value as the screen shows it: a row's label, a number without needless digits, a short vector.
std::string value_text(const Option&, const Settings&);

std::string grouped(uint64_t number);            // 1 234 567
std::string capitalised(std::string_view text);  // the tables' helps begin in lower case

}  // namespace gbl::ui
