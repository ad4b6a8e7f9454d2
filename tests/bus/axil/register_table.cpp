#include "register_table.hpp"

#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace hwffd::test {
namespace {

/// The cells of a line; a quoted one may contain commas.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A number, nothing, or "version": the part of it that the field is named after.
std::uint32_t reset_of(const std::string& cell, const std::string& name) {
  static const std::map<std::string, std::uint32_t> version = {{"major", PROJECT_VERSION_MAJOR},
                                                               {"minor", PROJECT_VERSION_MINOR},
                                                               {"patch", PROJECT_VERSION_PATCH}};
  if (cell == "version") return version.at(name);
  return cell.empty() ? 0 : static_cast<std::uint32_t>(std::stoul(cell, nullptr, 0));
}

void name_port(RegisterField& field) {
  field.port = field.reg;
  if (field.name != "value") {
    field.port += "_" + field.name;
  } else if (ends_with(field.reg, "_LO") || ends_with(field.reg, "_HI")) {
    field.port_low = ends_with(field.reg, "_HI") ? 32 : 0;
    field.port.resize(field.port.size() - 3);
  }
  for (char& c : field.port) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

const std::vector<std::string>& RegisterField::linked(const std::string& kind) const {
  static const std::vector<std::string> none;
  const auto it = links.find(kind);
  return it == links.end() ? none : it->second;
}

std::vector<RegisterField> read_register_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<RegisterField> fields;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const auto cells = cells_of(line);
    if (cells.size() != 8) throw std::runtime_error(path + ": not 8 cells: " + line);
    RegisterField field;
    field.offset = static_cast<std::uint32_t>(std::stoul(cells[0], nullptr, 16));
    field.reg = cells[1];
    field.name = cells[2];
    const std::size_t colon = cells[3].find(':');
    const unsigned high = static_cast<unsigned>(std::stoul(cells[3]));
    field.low = colon == std::string::npos
                    ? high
                    : static_cast<unsigned>(std::stoul(cells[3].substr(colon + 1)));
    field.width = high - field.low + 1;
    field.access = cells[4];
    field.reset = reset_of(cells[5], field.name);
    field.path = field.reg + "." + field.name;
    std::istringstream links(cells[6]);
    for (std::string word; links >> word;) {
      const std::size_t at = word.find(':');
      field.links[word.substr(0, at)].push_back(word.substr(at + 1));
    }
    name_port(field);
    fields.push_back(field);
  }
  return fields;
}

const std::vector<RegisterField>& register_table() {
  static const auto table = read_register_table(HWFFD_REGISTER_TABLE);
  return table;
}

const RegisterField& register_field(const std::string& path) {
  for (const RegisterField& field : register_table()) {
    if (field.path == path) return field;
  }
  throw std::out_of_range("no field " + path);
}

std::uint32_t register_offset(const std::string& reg) {
  for (const RegisterField& field : register_table()) {
    if (field.reg == reg) return field.offset;
  }
  throw std::out_of_range("no register " + reg);
}

}  // namespace hwffd::test
