#include "renderer/gltf/gltf_json.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/json_error.h"
#include "renderer/gltf/gltf_container.h"
#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/gltf_schema.h"

namespace gbl {
namespace {

// Those a file may require: each is drawn, or changes nothing in what we draw.
constexpr std::string_view kExtensions[] = {
    "KHR_lights_punctual",    "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_specular", "KHR_materials_transmission",      "KHR_materials_unlit",
    "KHR_mesh_quantization",  "KHR_texture_transform",
};

}  // namespace

std::span<const std::string_view> gltf_extensions() { return kExtensions; }

namespace gltf {
namespace {

using nlohmann::json;

bool supported(std::string_view extension) {
  return std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions);
}

// JSON is UTF-8; old exporters wrote names in Latin-1. Bytes that are no UTF-8 are read as that.
std::string as_utf8(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    size_t length = byte < 0x80 ? 1 : byte >= 0xc2 && byte < 0xe0 ? 2 : byte >= 0xe0 && byte < 0xf0 ? 3 : 0;
    if (byte >= 0xf0 && byte < 0xf5) length = 4;
    bool whole = length > 0 && i + length <= text.size();
    for (size_t k = 1; whole && k < length; ++k) whole = (static_cast<unsigned char>(text[i + k]) & 0xc0) == 0x80;
    if (whole) {
      out.append(text.substr(i, length));
      i += length;
    } else {
      out += static_cast<char>(0xc0 | byte >> 6);
      out += static_cast<char>(0x80 | (byte & 0x3f));
      ++i;
    }
  }
  return out;
}

// The parser's message if it fails.
std::string try_parse(std::string_view text, json& into) {
  try {
    into = json::parse(text.begin(), text.end());
    return {};
  } catch (const json::exception& e) {
    return clean_name(without_library(e.what()));
  }
}

json parse(std::string_view text, Job& job) {
  check_json_shape(text, job);
  json file;
  const std::string failure = try_parse(text, file);
  if (failure.empty()) return file;
  if (!try_parse(as_utf8(text), file).empty())
    job.refuse(fmt::format("broken JSON: {}", failure), "copy or export the file again");
  job.note("the text is not UTF-8; read as Latin-1 where it is not");
  return file;
}

std::string text_of(const json& object, const char* member) {
  const auto found = object.find(member);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Specification 3.2: a minor version may only add; minVersion says what a reader must know.
void check_version(const json& file, Job& job) {
  const auto asset = file.find("asset");
  if (asset == file.end() || !asset->is_object())
    job.refuse("no 'asset' in it: this is no glTF", "give a glTF 2.0 file");
  const std::string version = text_of(*asset, "version"), least = text_of(*asset, "minVersion");
  const bool ours = version.substr(0, 2) == "2." && (least.empty() || least == "2.0");
  if (!ours)
    job.refuse(fmt::format("glTF version '{}'", clean_name(least.empty() ? version : least)), "export it as glTF 2.0");
}

void check_extensions(const json& file, Job& job) {
  std::vector<std::string> lacking, ignored;
  const auto gather = [&](const char* list, std::vector<std::string>& into) {
    const auto found = file.find(list);
    if (found == file.end() || !found->is_array()) return;
    for (const json& name : *found)
      if (name.is_string() && !supported(name.get_ref<const std::string&>()) && into.size() < kMaxWarnings)
        into.push_back(clean_name(name.get_ref<const std::string&>()));
  };
  gather("extensionsRequired", lacking);
  gather("extensionsUsed", ignored);
  if (!lacking.empty())
    job.refuse(fmt::format("it requires the extension {}", fmt::join(lacking, ", ")),
               fmt::format("export it without; supported: {}", fmt::join(kExtensions, ", ")));
  for (const std::string& name : ignored) job.note(fmt::format("the extension {} is not drawn", name));
}

// What whole features we leave out is said before their members are taken away.
void note_skipped(const json& file, Job& job) {
  const auto animations = file.find("animations");
  if (animations != file.end() && animations->is_array() && !animations->empty()) job.note("animations are not played");
  const auto meshes = file.find("meshes");
  if (meshes == file.end() || !meshes->is_array()) return;
  for (const json& mesh : *meshes) {
    const auto primitives = mesh.is_object() ? mesh.find("primitives") : mesh.end();
    if (!mesh.is_object() || primitives == mesh.end() || !primitives->is_array()) continue;
    for (const json& primitive : *primitives)
      if (primitive.is_object() && primitive.contains("targets"))
        job.note("morph targets are not drawn: meshes keep their base shape");
  }
}

json tidy_list(json& list, const Section& section, const json& file, Job& job) {
  if (list.size() > section.limit) job.refuse_limit(section.list, list.size(), section.limit);
  json kept = json::array();
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", section.list, i);
    try {
      tidy(list[i], *section.schema, file, where, job);
      kept.push_back(std::move(list[i]));
    } catch (const Broken& broken) {
      job.note(fmt::format("{}: {}; not used", where, broken.what()));
      kept.push_back(json::parse(section.stand_in));
    }
  }
  return kept;
}

std::vector<Source> take_sources(json& tidied, const char* list) {
  std::vector<Source> sources;
  for (json& element : tidied[list]) {
    Source source{clean_name(text_of(element, "name")),
                  {},
                  element.value("bufferView", -1),
                  element.value("byteLength", uint64_t{0})};
    if (element.contains("uri")) source.uri = std::move(element["uri"].get_ref<std::string&>());
    sources.push_back(std::move(source));
  }
  tidied.erase(list);
  return sources;
}

// The lights lie in an extension of the file, and nodes point at them from an extension of theirs.
void tidy_lights(json& file, json& tidied, Job& job) {
  json lights = json::array();
  const json::json_pointer place("/extensions/KHR_lights_punctual/lights");
  if (file.contains("extensions") && file["extensions"].is_object() && file.contains(place) && file[place].is_array())
    lights = tidy_list(file[place], lights_section(), file, job);
  for (size_t i = 0; i < tidied["nodes"].size(); ++i) {
    json& node = tidied["nodes"][i];
    const json::json_pointer use("/extensions/KHR_lights_punctual/light");
    if (!node.contains(use) || node[use].get<uint64_t>() < lights.size()) continue;
    job.note(fmt::format("nodes[{}]: 'light' is {}, but there are {} lights; left out", i, node[use].get<uint64_t>(),
                         lights.size()));
    node.erase("extensions");
  }
  if (!lights.empty()) tidied["extensions"]["KHR_lights_punctual"]["lights"] = std::move(lights);
}

// The library refuses a whole file for what concerns one mesh or camera: those cases are settled here.
void appease_library(json& tidied, Job& job) {
  for (size_t i = 0; i < tidied["bufferViews"].size(); ++i) {
    json& view = tidied["bufferViews"][i];
    const uint64_t stride = view.value("byteStride", uint64_t{0});
    if (stride <= 252 && stride % 4 == 0) continue;  // specification 5.11.4
    job.note(fmt::format("bufferViews[{}]: 'byteStride' is {}, not a multiple of 4 up to 252; not used", i, stride));
    view = json::parse(find_section("bufferViews")->stand_in);
  }
  for (size_t i = 0; i < tidied["accessors"].size(); ++i) {
    json& accessor = tidied["accessors"][i];
    const uint64_t type = accessor["componentType"].get<uint64_t>();
    const std::string shape = accessor["type"].get<std::string>();
    const bool known_shape =
        shape == "SCALAR" || shape == "VEC2" || shape == "VEC3" || shape == "VEC4" || shape == "MAT4";
    if (type >= 5120 && type <= 5126 && type != 5124 && known_shape) continue;  // specification 3.6.2.2
    job.note(fmt::format("accessors[{}]: component type {} as '{}'; not used", i, type, clean_name(shape)));
    accessor = json::parse(find_section("accessors")->stand_in);
  }
  for (json& camera : tidied["cameras"]) {
    const std::string type = camera["type"].get<std::string>();
    const bool known = type == "perspective" || type == "orthographic";
    if (!known || !camera.contains(type)) camera = json::parse(find_section("cameras")->stand_in);
  }
  for (json& light : tidied["extensions"]["KHR_lights_punctual"]["lights"])
    if (light["type"] == "spot" && !light.contains("spot")) light["spot"] = json::object();
  for (size_t m = 0; m < tidied["meshes"].size(); ++m)
    for (json& primitive : tidied["meshes"][m]["primitives"]) {
      if (!primitive.contains("indices")) continue;
      const json& accessor = tidied["accessors"][primitive["indices"].get<size_t>()];
      if (accessor.contains("bufferView")) continue;
      job.note(fmt::format("meshes[{}]: a primitive's indices have no data; not drawn", m));
      primitive["mode"] = -1;
      primitive.erase("indices");
    }
}

}  // namespace

TidyJson tidy_json(std::string_view text, Job& job) {
  json file = parse(text, job);
  if (!file.is_object()) job.refuse("the JSON text is not an object", "give a glTF 2.0 file");
  check_version(file, job);
  check_extensions(file, job);
  note_skipped(file, job);
  json tidied = {{"asset", {{"version", "2.0"}}}};
  // Lists of the right type first: their lengths are what indices are measured against.
  size_t count = 0;
  const Section* all = sections(count);
  for (const Section* section = all; section != all + count; ++section) {
    const auto list = file.find(section->list);
    if (list == file.end()) continue;
    if (!list->is_array()) job.refuse(fmt::format("'{}' is not a list", section->list), "export the model again");
  }
  for (const Section* section = all; section != all + count; ++section) {
    const auto list = file.find(section->list);
    tidied[section->list] = list == file.end() ? json::array() : tidy_list(*list, *section, file, job);
  }
  tidy_lights(file, tidied, job);
  const auto scene = file.find("scene");
  if (scene != file.end() && scene->is_number_unsigned() && *scene < tidied["scenes"].size()) tidied["scene"] = *scene;
  if (scene != file.end() && !tidied.contains("scene"))
    job.note(fmt::format("'scene' is none of the {} scenes; the first is shown", tidied["scenes"].size()));
  file = nullptr;
  appease_library(tidied, job);
  TidyJson result;
  result.buffers = take_sources(tidied, "buffers");
  result.images = take_sources(tidied, "images");
  result.text = tidied.dump();
  return result;
}

}  // namespace gltf
}  // namespace gbl
