#pragma once
// Rows as JSON: in the journal, in study.json and as `bench --json` prints them.
#include <optional>
#include <string>
#include <string_view>

#include "renderer/base/json_fwd.h"
#include "renderer/study/rows/study_row.h"

namespace gbl {

// 16 hex digits of the settings asked for, what is looked at left out: equal on every machine.
std::string row_key(const Settings&);

// {"study", "case", "key", "at", the columns or "failed", "settings"}: what makes a row findable comes first, so that a
// line of the journal can be read by its beginning.
Json to_json(const StudyRow&);
Json to_json(const ColumnValue&);  // null: not measured; JSON knows no infinity: "inf", "-inf", "nan"
void append_cells(Json& object, const std::vector<Cell>&);

// One line, and back: empty if it is no row; Error(bad_input) begins with `where` if it is one of another program.
std::string journal_line(const StudyRow&);
std::optional<StudyRow> parse_journal_line(std::string_view line, std::string_view where);

// As it stands in a cell of a table: empty if not measured, a text without its quotes.
std::string cell_text(const ColumnValue&);

}  // namespace gbl
