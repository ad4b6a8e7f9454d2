#include "hwffd/model/configuration.hpp"

#include <algorithm>
#include <stdexcept>

#include "hwffd/model/organizations.hpp"

namespace hwffd {
namespace {

template <class Row>
const Row& find(const std::vector<Row>& rows, const std::string& name, const std::string& what) {
  std::string names;
  for (const Row& row : rows) {
    if (name == row.name) return row;
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  }
  const std::string gone = gone_text(name);
  if (!gone.empty()) throw std::invalid_argument(gone);
  throw std::invalid_argument("no " + what + " named '" + name + "': one of " + names);
}

/// An organization as the names of rows have it, without its slash, between hyphens.
std::string word_of_rows(std::string name) {
  name.erase(std::remove(name.begin(), name.end(), '/'), name.end());
  return "-" + name + "-";
}

}  // namespace

const Configuration& find_configuration(const std::string& name) {
  return find(configurations(), name, "configuration");
}

std::string gone_text(const std::string& name) {
  const std::string words = word_of_rows(name);
  for (const Gone& one : gone_names()) {
    if (words.find(word_of_rows(one.name)) != std::string::npos) return one.text;
  }
  return "";
}

const Organization& organization_of(const Configuration& row) {
  return find(organization_table(), row.org, "organization");
}

}  // namespace hwffd
