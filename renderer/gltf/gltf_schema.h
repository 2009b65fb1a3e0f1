#pragma once
// What the loader reads of glTF, as rows: member, kind, need. A member that has no row is not read.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "renderer/gltf/gltf_job.h"

namespace gbl::gltf {

enum class Kind { text, flag, number, numbers, size, index, indices, object, objects };
enum class Need {
  optional,  // if it is wrong it is left out
  sound,     // may be missing; if it is wrong its object cannot be used
  required,  // its object cannot be used without it
};

struct Schema;
struct Member {
  const char* name;
  Kind kind;
  Need need = Need::optional;
  int length = 0;                  // of numbers
  const char* list = nullptr;      // of index and indices: the top-level list they point into
  const Schema* schema = nullptr;  // of object and objects
};
struct Schema {
  const Member* members;
  size_t count;
};

// A top-level list of the file.
struct Section {
  const char* list;
  const char* stand_in;  // JSON of an element that means nothing, put where a broken one was: indices stay true
  const Schema* schema;
  uint64_t limit;
};
const Section* find_section(std::string_view list);
const Section* sections(size_t& count);
const Section& lights_section();  // of KHR_lights_punctual

// Keeps of `value` what the schema knows. Broken if what is left cannot be used.
// counts: the file, for the lengths of its lists.
void tidy(nlohmann::json& value, const Schema&, const nlohmann::json& file, const std::string& where, Job&);

}  // namespace gbl::gltf
