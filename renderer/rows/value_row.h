#pragma once
// Every choice that a setting can take is a row of a table, one table per enum. The UI's combos, the command line, JSON,
// the docs' tables and the tests all follow from these rows.
#include <cstddef>
#include <span>
#include <string_view>

#include "renderer/base/features.h"
#include "renderer/pitfalls/pitfalls.h"

namespace gbl {

struct ValueRow {
  int value;                        // == its index; checked at compile time
  const char* id;                   // kebab-case; a promise: changing one is a CHANGELOG line
  const char* label;                // for the screen
  const char* help;                 // one line: what it does
  const char* cost = "";            // bits, bytes or pairs it costs; empty = nothing beyond the axis' other rows
  const char* source = "";          // author, year, title
  Pitfall pitfall = Pitfall::none;  // none = sound; else the failure that this row shows
  Feature needs = Feature::none;

  constexpr bool sound() const { return pitfall == Pitfall::none; }
};

// The table of an enum; defined beside its rows (renderer/rows/value_table.h).
template <class E>
std::span<const ValueRow> rows();

template <class E>
const ValueRow& row(E value) {
  return rows<E>()[static_cast<size_t>(value)];
}

// Index of the row with this id; an unknown id is an Error naming `where` that lists the known ones.
int parse_id(std::span<const ValueRow> table, std::string_view id, std::string_view where,
             std::string_view noun = "value");

}  // namespace gbl
