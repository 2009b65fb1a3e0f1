#pragma once
// JSON: only where a file or an answer is read or written. In between, values are typed.
#include <nlohmann/json.hpp>
#include <optional>

#include "renderer/base/json_fwd.h"

namespace gbl {

// Null: unknown, not measured.
template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace gbl
