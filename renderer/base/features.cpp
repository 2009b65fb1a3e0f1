#include "renderer/base/features.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"

namespace gbl {

FeatureSet parse_features(std::string_view list) {
  FeatureSet set;
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    const std::string_view id = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    const auto* row = std::find_if(std::begin(kFeatures), std::end(kFeatures), [&](auto& r) { return r.id == id; });
    if (row == std::end(kFeatures)) {
      std::vector<std::string_view> known;
      for (const FeatureRow& r : kFeatures) known.push_back(r.id);
      throw Error(ExitCode::bad_input, "--without", fmt::format("unknown feature '{}'", id), suggest(id, known));
    }
    set.add(row->feature);
  }
  return set;
}

}  // namespace gbl
