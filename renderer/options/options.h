#pragma once
// The options table: everything that can be set, one row each. JSON, --set, the UI's combos, keys, docs and tests
// follow from it. A path is a promise; no path is the beginning of another at a dot.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/option_value.h"
#include "renderer/options/settings.h"

namespace gbl {

enum class Group { truth, method, view };
enum class Kind { choice, integer, number, text, vector, set };

// When an option changes anything; else what it is that does not use it, in words: "method forward".
struct Use {
  bool (*now)(const Settings&);
  std::string (*who_does_not)(const Settings&);
  bool by_lighting = false;  // only by lighting that draws volumes
};

struct Option {
  const char* path;
  Group group;
  const char* label;
  const char* help;
  const char* key = "";  // one letter on the keyboard; "" = reached through `O`
  const char* unit = "";
  Kind kind;
  std::span<const ValueRow> values = {};  // of a choice
  double min = 0, max = 0;                // of integer, number and each member of a vector; both ends allowed
  OptionValue (*get)(const Settings&) = nullptr;
  void (*set)(Settings&, const OptionValue&, const Option&) = nullptr;  // throws Error naming the path
  const Use* use = nullptr;                                             // null: always in use
  // What else is meant by whoever sets it by hand: a number of lights means generated ones.
  void (*implies)(Settings&) = nullptr;
};

std::span<const Option> options();
const Option& option(std::string_view path);  // Error with the nearest paths if unknown

// Values by path, as lessons, studies and arguments give them.
struct Assignment {
  std::string path;
  OptionValue value;
  bool operator==(const Assignment&) const = default;
};
// All or nothing: Error(bad_input) begins with `where`.
void apply_patch(Settings&, const std::vector<Assignment>&, std::string_view where);

// Index of a choice's current row.
int chosen(const Option&, const Settings&);
// The next (step 1) or previous (-1) row, cyclic; rows whose feature is missing are passed over.
void cycle(const Option&, Settings&, int step, FeatureSet available);

// False: under these settings the option changes nothing, sound or not.
bool in_use(const Option&, const Settings&);

std::string_view group_id(Group);

}  // namespace gbl
