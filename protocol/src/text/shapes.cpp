#include "shapes.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/written_marks.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

#include "bracketed_lists.hpp"
#include "characters.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }

void require_numbers(std::size_t count) {
    require_within(count, Limits{}.numbers, "numbers", "the count of numbers");
}

/// Appends a number, or "0*4" as four numbers.
void append_number(Json::Array& numbers, std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const WrittenMark mark = written_mark(text.substr(at));
        const auto count =
            at > 0 && mark.meaning == '*' ? repetitions(text.substr(at + mark.length)) : std::nullopt;
        if (count) {
            require_numbers(numbers.size() + *count);
            numbers.insert(numbers.end(), *count, Json(trimmed(text.substr(0, at))));
            return;
        }
        at += mark.length;
    }
    numbers.emplace_back(text);
}

/// The parts of a row: at its commas, or at its blanks where there are none.
Json::Array numbers_of(std::string_view row) {
    Json::Array numbers;
    if (row.find(',') != std::string_view::npos) {
        for (const std::string& part : split(row, ',')) append_number(numbers, part);
        return numbers;
    }
    while (!row.empty()) {
        const std::size_t length = std::min(row.find_first_of(blanks), row.size());
        append_number(numbers, row.substr(0, length));
        row = trimmed(row.substr(length));
    }
    return numbers;
}

/// The parts of a line "0,0 1,2" between blanks that stand next to no comma.
std::vector<std::string_view> between_blanks(std::string_view line) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!is_blank(line[i])) continue;
        const std::size_t next = line.find_first_not_of(blanks, i);
        if (line[i - 1] != ',' && line[next] != ',') {
            parts.push_back(line.substr(begin, i - begin));
            begin = next;
        }
        i = next - 1;
    }
    parts.push_back(line.substr(begin));
    return parts;
}

/// The rows of one line, which has no ';'.
std::vector<Json::Array> rows_of_line(std::string_view text, std::string_view line) {
    const std::vector<std::string_view> parts = between_blanks(line);
    const bool commas = line.find(',') != std::string_view::npos;
    if (!commas || parts.size() == 1) return {numbers_of(line)};
    std::vector<Json::Array> rows;
    for (const std::string_view part : parts) {
        rows.push_back(numbers_of(part));
        if (rows.back().size() == rows.front().size() && rows.front().size() > 1) continue;
        throw Error(ErrorCode::syntax,
                    "points are separated by ';', and their coordinates by ',', in " + quoted(line), {},
                    static_cast<std::size_t>(part.data() - text.data()));
    }
    return rows;
}

/// Whether a line has names of columns instead of numbers.
bool is_heading(std::string_view line) {
    const std::vector<std::string> names = split(line, line.find(',') == std::string_view::npos ? '\t' : ',');
    return std::ranges::all_of(names, [](std::string_view name) {
        const bool is_word = std::ranges::all_of(name, [](char c) { return is_letter(c) || is_blank(c); });
        return !name.empty() && is_word && name != "nan" && name != "inf";
    });
}

/// The lines of a text that have something in them; a heading is left out.
std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        if (const std::string_view line = trimmed(text.substr(0, length)); !line.empty())
            lines.push_back(line);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    if (lines.size() > 1 && is_heading(lines.front())) lines.erase(lines.begin());
    return lines;
}

/// The rows of a text without brackets.
std::vector<Json::Array> rows_of(std::string_view text) {
    std::vector<Json::Array> rows;
    std::size_t numbers = 0;
    std::string_view rest = text;
    while (!trimmed(rest).empty()) {
        const std::size_t length = std::min(rest.find(';'), rest.size());
        const std::vector<std::string_view> lines = lines_of(rest.substr(0, length));
        if (lines.empty()) rows.push_back({Json("")});
        for (const std::string_view line : lines) {
            for (Json::Array& row : rows_of_line(text, line)) {
                numbers += row.size();
                require_numbers(numbers);
                rows.push_back(std::move(row));
            }
        }
        rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    return rows;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    if (trimmed(text).empty()) return parts;
    while (true) {
        const std::size_t length = std::min(text.find(separator), text.size());
        parts.emplace_back(trimmed(text.substr(0, length)));
        if (length == text.size()) return parts;
        text.remove_prefix(length + 1);
    }
}

Json number_list(std::string_view text) {
    if (is_bracketed(text)) return bracketed_list(text);
    std::vector<Json::Array> rows = rows_of(text);
    if (rows.size() == 1) return std::move(rows.front());
    Json::Array list;
    for (Json::Array& row : rows) {
        if (row.size() == 1) {
            list.push_back(std::move(row.front()));
        } else {
            list.emplace_back(std::move(row));
        }
    }
    return list;
}

Json tuple_list(std::string_view text) {
    Json::Array list;
    if (is_bracketed(text)) {
        Json read = bracketed_list(text);
        const Json::Array& elements = *read.array();
        const bool nested =
            std::ranges::any_of(elements, [](const Json& element) { return element.array(); });
        if (nested || elements.empty()) return read;
        list.push_back(std::move(read));
        return list;
    }
    for (Json::Array& row : rows_of(text)) list.emplace_back(std::move(row));
    return list;
}

}  // namespace blossom::protocol
