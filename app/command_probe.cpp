// `probe X Y`: one pixel of a frame, stored and decoded.
#include <algorithm>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/lab.h"
#include "renderer/base/json.h"
#include "renderer/base/size_text.h"
#include "renderer/inspect/stored_bits.h"

namespace gbl {
namespace {

// The fields that these settings store, each with as many numbers as it has components.
template <class Use>
void each_field(const PixelProbe& p, const Settings& drawn, Use use) {
  for (size_t i = 0; i < probe_fields().size(); ++i) {
    const ProbeFieldRow& field = probe_fields()[i];
    if (!why_missing(field.view, drawn).empty()) continue;
    const glm::vec4& v = p.values[i];
    use(field, std::vector<float>{&v.x, &v.x + field.components});
  }
}

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const std::vector<AccountLine>& lines) {
  Json out = Json::array();
  for (const AccountLine& l : lines)
    out.push_back({{"what", l.what},
                   {"unit", l.unit},
                   {"drawn", l.drawn.empty() ? Json() : Json(l.drawn)},
                   {"truth", l.truth},
                   {"error", l.drawn.empty() ? Json() : Json(l.error)},
                   {"off", l.off}});
  return out;
}

Json json_of(const std::vector<LightShare>& lights) {
  Json out = Json::array();
  for (const LightShare& l : lights)
    out.push_back({{"light", l.index},
                   {"distance", l.distance < kEndless ? Json(l.distance) : Json()},
                   {"range", l.range < kEndless ? Json(l.range) : Json()},
                   {"arriving", l.arriving},
                   {"hidden", l.hidden},
                   {"n_dot_l", l.n_dot_l},
                   {"diffuse", json_of(l.diffuse)},
                   {"specular", json_of(l.specular)},
                   {"share", l.share},
                   {"times_shaded", l.shaded ? Json(*l.shaded) : Json()},
                   {"verdict", verdict_of(l)}});
  return out;
}

Json fields_of(const Settings& drawn, const StoredTexel& t) {
  Json out = Json::array();
  for (const FieldRead& r : read_fields(drawn, t))
    out.push_back(
        {{"name", r.field.name}, {"bits", r.place}, {"binary", r.binary}, {"codes", r.codes}, {"values", r.values}});
  return out;
}

Json json_of(const DepthAccount& d) {
  return {{"code", d.code},         {"bits", d.bits},   {"window", d.window},
          {"distance", d.distance}, {"truth", d.truth}, {"step", d.step}};
}

Json json_of(const std::vector<PositionRoute>& routes) {
  Json out = Json::array();
  for (const PositionRoute& r : routes)
    out.push_back({{"route", name_of(r)},
                   {"position", json_of(r.position)},
                   {"error", r.error},
                   {"used", r.used},
                   {"pitfall", std::string(pitfall_of(r))}});
  return out;
}

void print_json(const PixelProbe& p, const PixelAccount& account, const Lab& lab) {
  Json json = {{"x", p.pixel.x}, {"y", p.pixel.y}, {"surface", p.surface()}};
  json["object_name"] = object_name(p, lab.scene());
  json["stored"] = Json::array();
  for (const StoredTexel& t : p.stored) {
    const FormatRow& format = row(t.attachment.format);
    Json bits = Json::array();
    for (int c = 0; c < format.channels; ++c) bits.push_back(t.bits[static_cast<size_t>(c)]);
    json["stored"].push_back({{"name", t.attachment.name},
                              {"format", format.label},
                              {"bits", bits},
                              {"hex", hex(t)},
                              {"contents", t.attachment.contents},
                              {"fields", fields_of(lab.report().drawn, t)}});
  }
  json["decoded"] = Json::array();
  each_field(p, lab.drawn(), [&](const ProbeFieldRow& field, const std::vector<float>& values) {
    const Json value = field.components == 1 ? Json(values[0]) : Json(values);
    json["decoded"].push_back({{"path", field.path}, {"value", value}, {"unit", field.unit}});
  });
  json["truth"] = {{"surface", account.surface},
                   {"object", account.seen.object},
                   {"triangle", account.seen.triangle},
                   {"tie", account.tie}};
  json["shown"] = {{"object", account.shown.object}, {"triangle", account.shown.triangle}};
  if (account.surface) json["depth"] = json_of(account.depth);
  json["positions"] = json_of(account.routes);
  json["against_truth"] = json_of(account.stored);
  json["lights"] = json_of(account.lights);
  json["sum"] = json_of(account.terms);
  json["first_off"] = account.first_off < 0 ? Json() : Json(account.terms[static_cast<size_t>(account.first_off)].what);
  fmt::print("{}\n", json.dump(2));
}

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += fmt::format("{:>13.7g}", v);
  return text;
}

void print_lines(const std::vector<AccountLine>& lines, int first_off) {
  fmt::print("  {:<24}{:<41}{:<41}{:<11}\n", "", "drawn", "truth", "error");
  for (size_t i = 0; i < lines.size(); ++i) {
    const AccountLine& l = lines[i];
    fmt::print("  {:<24}{:<41}{:<41}{:<11}{}{}\n", l.what, l.drawn.empty() ? "  not stored" : numbers(l.drawn),
               numbers(l.truth), l.drawn.empty() ? "" : fmt::format("{:.3g}", l.error), l.unit,
               static_cast<int>(i) == first_off ? "   <- the first that goes wrong" : "");
  }
}

void print_positions(const PixelAccount& a) {
  const DepthAccount& d = a.depth;
  fmt::print("\ndepth, with all digits\n");
  fmt::print("  code {}, window depth {:.9g}, distance {:.9g}, truth {:.9g}; the next code lies {:.3g} farther\n",
             code_text(d), d.window, d.distance, d.truth, d.step);
  if (!a.routes.empty()) fmt::print("\nposition, by each way to store it\n  {:<36}{:<47}{:<11}\n", "", "read", "error");
  for (const PositionRoute& r : a.routes)
    fmt::print("  {:<36}{:<47}{:<11.3g}{}{}\n", name_of(r),
               fmt::format("{:>15.9g}{:>15.9g}{:>15.9g}  ", r.position.x, r.position.y, r.position.z), r.error,
               r.used ? "used" : "", pitfall_of(r).empty() ? "" : fmt::format("  unsound: {}", pitfall_of(r)));
}

void print_account(const PixelAccount& a) {
  if (const std::string note = other_surface_note(a); !note.empty()) fmt::print("\n{}\n", note);
  if (!a.stored.empty()) fmt::print("\nagainst the reference in double precision\n");
  if (!a.stored.empty()) print_lines(a.stored, -1);
  if (a.surface) print_positions(a);
  if (a.surface)
    fmt::print("\n{} light{} it{}\n", a.lights.size(), a.lights.size() == 1 ? " reaches" : "s reach",
               a.lights.empty() ? "" : ", the strongest first");
  if (!a.lights.empty())
    fmt::print("  {:>6}{:>12}{:>8}{:>12}{:>8}  {:<36}{:<36}{:>8}  {}\n", "light", "distance", "d/r", "arriving", "N.L",
               "diffuse", "specular", "share", "shaded");
  for (const LightShare& l : a.lights) {
    const bool endless = l.range >= kEndless;
    const auto three = [](const glm::dvec3& v) { return fmt::format("{:>11.4g} {:>11.4g} {:>11.4g}", v.x, v.y, v.z); };
    fmt::print("  {:>6}{:>12}{:>8}{:>12}{:>8.3f} {} {}{:>7.2f}%  {}{}\n", l.index,
               l.distance < kEndless ? fmt::format("{:.5g}", l.distance) : "-",
               endless ? "-" : fmt::format("{:.3f}", l.distance / l.range),
               l.hidden ? "hidden" : fmt::format("{:.4g}", l.arriving), l.n_dot_l, three(l.diffuse), three(l.specular),
               100 * l.share, l.shaded ? fmt::format("{}", *l.shaded) : "-",
               verdict_of(l).empty() ? "" : " " + verdict_of(l));
  }
  fmt::print("\nthe sum\n");
  print_lines(a.terms, a.first_off);
}

void print_field(const FieldRead& r) {
  std::string codes, values;
  for (const uint32_t c : r.codes) codes += fmt::format(" {}", c);
  for (const double v : r.values) values += fmt::format(" {:.7g}", v);
  const bool meant = r.field.name != kUnusedBits;
  fmt::print("    {:<30} {:<28} {}{}{}\n", r.field.name, "bits " + r.place, fmt::join(r.binary, "  "),
             meant && r.field.kind != CodeKind::floating ? "  code" + codes : "", meant ? "  means" + values : "");
}

void print_text(const PixelProbe& p, const Lab& lab) {
  const std::string_view name = object_name(p, lab.scene());
  fmt::print("pixel {}, {} of {}: {}\n\nstored: hexadecimal, then the bits of each field\n", p.pixel.x, p.pixel.y,
             size_text(lab.drawn().size),
             !name.empty() ? name
             : p.surface() ? "a surface"
                           : "the background");
  for (const StoredTexel& t : p.stored) {
    fmt::print("  {:<24} {:<11} {:<36} {}\n", t.attachment.name, row(t.attachment.format).label, hex(t),
               t.attachment.contents);
    for (const FieldRead& r : read_fields(lab.report().drawn, t)) print_field(r);
  }
  fmt::print("\ndecoded, as the lighting reads it\n");
  each_field(p, lab.drawn(), [](const ProbeFieldRow& field, const std::vector<float>& values) {
    std::string numbers;
    for (const float v : values) numbers += fmt::format("{:>14.7g} ", v);
    fmt::print("  {:<15} {:<46}{}\n", field.path, numbers, field.unit);
  });
}

}  // namespace

ExitCode run_probe(const Arguments& a) {
  const auto [s, scene] = setup_of(a);
  const glm::ivec2 pixel{a.pixel_x.value(), a.pixel_y.value()};
  if (pixel.x >= s.size.x || pixel.y >= s.size.y)
    throw Error(
        ExitCode::bad_input, fmt::format("pixel {} {}", pixel.x, pixel.y),
        fmt::format("it lies outside the picture of {}", size_text(s.size)),
        fmt::format("choose 0 to {} and 0 to {}, from the top left; or another --size", s.size.x - 1, s.size.y - 1));
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.draw(s);
  lab.start_probe(pixel);
  const PixelProbe probe = lab.take_probe(true).value();
  PixelAccount account = lab.account(probe, true).value();
  count_lights(lab, account, 64);  // the strongest: each takes a pass of its own
  if (a.json) {
    print_json(probe, account, lab);
  } else {
    print_text(probe, lab);
    print_account(account);
  }
  return ExitCode::done;
}

}  // namespace gbl
