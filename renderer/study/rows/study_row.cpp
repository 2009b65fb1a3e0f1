#include "renderer/study/rows/study_row.h"

#include <algorithm>
#include <cmath>

namespace gbl {
namespace {

template <class T>
const T* value_in(const StudyRow& row, std::string_view column) {
  for (const Cell& c : row.cells)
    if (c.column == column) return std::get_if<T>(&c.value);
  return nullptr;
}

}  // namespace

std::optional<double> StudyRow::number(std::string_view column) const {
  const auto* n = value_in<Number>(*this, column);
  return n ? std::optional(n->value) : std::nullopt;
}

std::string StudyRow::text(std::string_view column) const {
  const auto* text = value_in<std::string>(*this, column);
  return text ? *text : "";
}

std::optional<double> column_value(const StudyRow& row, const StudyColumn& c) {
  if (c.numerator.empty()) {
    const auto value = row.number(c.id);
    return value && c.magnitude ? std::abs(*value) : value;
  }
  const auto over = row.number(c.numerator), under = row.number(c.denominator);
  if (!over || !under || *under == 0) return {};
  return *over / *under;
}

bool is_noisy(const StudyRow& row, const StudyColumn& c) {
  const auto median = row.number(c.id), p10 = row.number(c.p10), p90 = row.number(c.p90);
  return median && p10 && p90 && noisy({*median, *p10, *p90});
}

bool measured_enough(int frames, double seconds, double slowest_s) {
  if (frames >= 20) return true;
  return seconds >= 20 && frames >= (slowest_s > 20 ? 1 : 3);
}

}  // namespace gbl
