#pragma once
// For the files that hold tables of value rows.
#include <array>
#include <cstddef>

#include "renderer/rows/value_row.h"

namespace gbl {

template <class E>
constexpr int at(E e) {
  return static_cast<int>(e);
}

template <class Table>
constexpr bool in_order(const Table& table) {
  for (size_t i = 0; i < std::size(table); ++i)
    if (table[i].value != static_cast<int>(i)) return false;
  return true;
}

// The value rows within the rows of a larger table, numbered in its order.
template <const auto& kTable, class Value>
constexpr auto values_of(Value value) {
  std::array<ValueRow, std::size(kTable)> out{};
  for (size_t i = 0; i < out.size(); ++i) {
    out[i] = value(kTable[i]);
    out[i].value = static_cast<int>(i);
  }
  return out;
}

}  // namespace gbl

// Makes `table` what rows<Enum>() gives.
#define GBL_ROWS(Enum, table)                                \
  static_assert(in_order(table), "row i must have value i"); \
  template <>                                                \
  std::span<const ValueRow> rows<Enum>() {                   \
    return table;                                            \
  }
