#include "renderer/gltf/gltf_schema.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gbl::gltf {
namespace {

using nlohmann::json;

constexpr double kMaxWhole = 2147483647;        // indices and counts are ints somewhere on their way
constexpr double kMaxSize = 9007199254740991.;  // 2^53 - 1: JSON's numbers are doubles

size_t length_of(const json& file, const char* list) {
  const auto found = file.find(list);
  return found != file.end() && found->is_array() ? found->size() : 0;
}

// A whole number in 0..limit, also if it is written "12.0". Kept as an unsigned integer.
void whole(json& value, double limit) {
  if (!value.is_number()) throw Broken("is not a number");
  const double number = value.get<double>();
  if (!(number >= 0 && number <= limit && std::floor(number) == number))
    throw Broken(fmt::format("is {}, not a whole number from 0 to {}", number, limit));
  value = static_cast<uint64_t>(number);
}

void index_into(json& value, const json& file, const char* list) {
  whole(value, kMaxWhole);
  const size_t length = length_of(file, list);
  if (value.get<uint64_t>() >= length)
    throw Broken(fmt::format("is {}, but there are {} {}", value.get<uint64_t>(), length, list));
}

void all_numbers(const json& value, int length) {
  if (!value.is_array() || value.size() != static_cast<size_t>(length))
    throw Broken(fmt::format("is not a list of {} numbers", length));
  for (const json& number : value)
    if (!number.is_number()) throw Broken(fmt::format("is not a list of {} numbers", length));
}

// Wrong entries go, unless the order matters (joints), which Need says.
void all_indices(json& value, const Member& member, const json& file, const std::string& where, Job& job) {
  if (!value.is_array()) throw Broken("is not a list");
  json kept = json::array();
  for (json& entry : value) try {
      index_into(entry, file, member.list);
      kept.push_back(std::move(entry));
    } catch (const Broken& broken) {
      if (member.need != Need::optional) throw;
      job.note(fmt::format("{}.{}: an entry {}; left out", where, member.name, broken.what()));
    }
  value = std::move(kept);
}

void all_objects(json& value, const Member& member, const json& file, const std::string& where, Job& job) {
  if (!value.is_array()) throw Broken("is not a list");
  json kept = json::array();
  for (size_t i = 0; i < value.size(); ++i) {
    const std::string here = fmt::format("{}.{}[{}]", where, member.name, i);
    try {
      tidy(value[i], *member.schema, file, here, job);
      kept.push_back(std::move(value[i]));
    } catch (const Broken& broken) {
      job.note(fmt::format("{}: {}; left out", here, broken.what()));
    }
  }
  value = std::move(kept);
}

void tidy_member(json& value, const Member& member, const json& file, const std::string& where, Job& job) {
  switch (member.kind) {
    case Kind::text:
      if (!value.is_string()) throw Broken("is not a text");
      return;
    case Kind::flag:
      if (!value.is_boolean()) throw Broken("is neither true nor false");
      return;
    case Kind::number:
      if (!value.is_number()) throw Broken("is not a number");
      return;
    case Kind::numbers: return all_numbers(value, member.length);
    case Kind::size: return whole(value, std::string_view(member.name).substr(0, 4) == "byte" ? kMaxSize : kMaxWhole);
    case Kind::index: return index_into(value, file, member.list);
    case Kind::indices: return all_indices(value, member, file, where, job);
    case Kind::object: return tidy(value, *member.schema, file, fmt::format("{}.{}", where, member.name), job);
    case Kind::objects: return all_objects(value, member, file, where, job);
  }
}

}  // namespace

const Section* find_section(std::string_view list) {
  size_t count = 0;
  const Section* all = sections(count);
  for (const Section* section = all; section != all + count; ++section)
    if (section->list == list) return section;
  return nullptr;
}

void tidy(json& value, const Schema& schema, const json& file, const std::string& where, Job& job) {
  if (!value.is_object()) throw Broken("is not an object");
  json kept = json::object();
  for (const Member* member = schema.members; member != schema.members + schema.count; ++member) {
    const auto found = value.find(member->name);
    if (found == value.end()) {
      if (member->need == Need::required) throw Broken(fmt::format("'{}' is missing", member->name));
      continue;
    }
    try {
      tidy_member(*found, *member, file, where, job);
      kept[member->name] = std::move(*found);
    } catch (const Broken& broken) {
      const std::string text = fmt::format("'{}' {}", member->name, broken.what());
      if (member->need != Need::optional) throw Broken(text);
      job.note(fmt::format("{}: {}; left out", where, text));
    }
  }
  value = std::move(kept);
}

}  // namespace gbl::gltf
