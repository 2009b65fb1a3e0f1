#include "renderer/rows/value_row.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"

namespace gbl {

int parse_id(std::span<const ValueRow> table, std::string_view id, std::string_view where, std::string_view noun) {
  std::vector<std::string_view> known;
  for (const ValueRow& r : table) {
    if (r.id == id) return r.value;
    known.push_back(r.id);
  }
  throw Error(ExitCode::bad_input, where, fmt::format("unknown {} '{}'", noun, id), suggest(id, known));
}

}  // namespace gbl
