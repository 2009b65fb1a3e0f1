#include "tests/gltf/gltf_fixture.h"

#include <fstream>
#include <unistd.h>

#include "renderer/base/error.h"

namespace gbl::test {
namespace {

void put32(Bytes& out, uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<uint8_t>(value >> shift));
}

void put32_big(Bytes& out, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<uint8_t>(value >> shift));
}

// PNG specification, annex D.
uint32_t crc32(const Bytes& bytes) {
  uint32_t crc = 0xffffffff;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

void put_chunk(Bytes& out, const char* type, const Bytes& body) {
  put32_big(out, static_cast<uint32_t>(body.size()));
  Bytes checked(type, type + 4);
  checked.insert(checked.end(), body.begin(), body.end());
  out.insert(out.end(), checked.begin(), checked.end());
  put32_big(out, crc32(checked));
}

// zlib with one stored block (RFC 1950, RFC 1951): no compression needed for a few texels.
Bytes stored(const Bytes& raw) {
  Bytes out = {0x78, 0x01, 0x01};
  const auto size = static_cast<uint16_t>(raw.size());
  for (const uint16_t word : {size, static_cast<uint16_t>(~size)})
    out.insert(out.end(), {static_cast<uint8_t>(word), static_cast<uint8_t>(word >> 8)});
  out.insert(out.end(), raw.begin(), raw.end());
  uint32_t a = 1, b = 0;
  for (const uint8_t byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
  put32_big(out, b << 16 | a);
  return out;
}

}  // namespace

int GltfFile::view(const Bytes& bytes, int stride) {
  buffer.resize((buffer.size() + 3) / 4 * 4);
  json element = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
  if (stride) element["byteStride"] = stride;
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  return add("bufferViews", std::move(element));
}

int GltfFile::add(const char* list, json element) {
  doc[list].push_back(std::move(element));
  return static_cast<int>(doc[list].size()) - 1;
}

int GltfFile::accessor(int view, size_t offset, int component, const char* type, size_t count, bool normalised) {
  json element = {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
  if (offset) element["byteOffset"] = offset;
  if (normalised) element["normalized"] = true;
  return add("accessors", std::move(element));
}

size_t GltfFile::components(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<size_t>(type.back() - '0');
}

int GltfFile::place(json primitive) {
  const int mesh = add("meshes", {{"primitives", json::array({std::move(primitive)})}});
  const int index = add("nodes", {{"mesh", mesh}});
  if (!doc.contains("scenes")) doc["scenes"] = json::array({{{"nodes", json::array()}}});
  doc["scenes"][0]["nodes"].push_back(index);
  return index;
}

std::string GltfFile::gltf() const {
  json full = doc;
  if (!buffer.empty() && !full.contains("buffers"))
    full["buffers"] = json::array(
        {{{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}});
  return full.dump();
}

Bytes GltfFile::glb() const {
  json full = doc;
  if (!buffer.empty() && !full.contains("buffers")) full["buffers"] = json::array({{{"byteLength", buffer.size()}}});
  std::string text = full.dump(-1, ' ', false, json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  Bytes body = buffer;
  body.resize((body.size() + 3) / 4 * 4);
  Bytes out = {'g', 'l', 'T', 'F'};
  put32(out, 2);
  put32(out, static_cast<uint32_t>(12 + 8 + text.size() + (body.empty() ? 0 : 8 + body.size())));
  put32(out, static_cast<uint32_t>(text.size()));
  put32(out, 0x4e4f534a);
  out.insert(out.end(), text.begin(), text.end());
  if (body.empty()) return out;
  put32(out, static_cast<uint32_t>(body.size()));
  put32(out, 0x004e4942);
  out.insert(out.end(), body.begin(), body.end());
  return out;
}

Scene GltfFile::load() const { return load_gltf_from_memory(glb(), "test"); }

json position_only(int position) { return {{"attributes", {{"POSITION", position}}}}; }

GltfFile triangle_file() {
  GltfFile file;
  file.place(position_only(file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")));
  return file;
}

GltfFile textured_file() {
  GltfFile file;
  const int position = file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const int normal = file.numbers<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int uv = file.numbers<float>({0, 1, 1, 1, 0, 0}, "VEC2");
  const Bytes picture = png_rgba(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 6});
  file.add("images", {{"bufferView", file.view(picture)}, {"mimeType", "image/png"}});
  file.add("textures", {{"source", 0}});
  file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file.place({{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}, {"material", 0}});
  return file;
}

Bytes bytes_of(const std::string& text) { return Bytes(text.begin(), text.end()); }

std::string base64(const Bytes& bytes) {
  constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kAlphabet[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

Bytes png(int width, int height, int bit_depth, int colour_type, const Bytes& rows, const Bytes& palette) {
  Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header, raw;
  put32_big(header, static_cast<uint32_t>(width));
  put32_big(header, static_cast<uint32_t>(height));
  for (const int field : {bit_depth, colour_type, 0, 0, 0}) header.push_back(static_cast<uint8_t>(field));
  const size_t row = height > 0 ? rows.size() / static_cast<size_t>(height) : 0;
  for (size_t y = 0; y < static_cast<size_t>(height); ++y) {
    raw.push_back(0);  // no filter
    raw.insert(raw.end(), rows.begin() + static_cast<long>(y * row), rows.begin() + static_cast<long>((y + 1) * row));
  }
  put_chunk(out, "IHDR", header);
  if (!palette.empty()) put_chunk(out, "PLTE", palette);
  put_chunk(out, "IDAT", stored(raw));
  put_chunk(out, "IEND", {});
  return out;
}

Bytes png_rgba(int width, int height, const Bytes& rgba) { return png(width, height, 8, 6, rgba); }

std::string refusal(const Bytes& bytes) {
  try {
    load_gltf_from_memory(bytes, "test");
    return {};
  } catch (const Error& error) {
    return error.code() == ExitCode::bad_input ? error.what() : std::string("wrong code: ") + error.what();
  }
}

std::string refusal(const GltfFile& file) { return refusal(file.glb()); }

bool has_warning(const Scene& scene, const std::string& part) {
  for (const std::string& line : scene.warnings)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

ScratchFolder::ScratchFolder(const std::string& name)
    : path(std::filesystem::temp_directory_path() / ("gbl_" + name + "_" + std::to_string(getpid()))) {
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name, const Bytes& bytes) const {
  std::ofstream out(path / name, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path / name;
}

}  // namespace gbl::test
