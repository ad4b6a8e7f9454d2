#include "plates/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "picture/png.hpp"

namespace hwffd::plates {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kColumns = 5;  // of the sheet

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw Error(fmt::format("{}: cannot be made: {}; give another folder by --output",
                          folder.string(), error.message()));
}

picture::Image sheet(const std::vector<Plate>& plates) {
  std::vector<picture::Image> small;
  for (const Plate& plate : plates) small.push_back(halved(halved(halved(plate.image))));
  return contact_sheet(small, kColumns);
}

}  // namespace

std::string file_name(std::size_t number) { return fmt::format("plate{:02}.png", number); }

std::string table_header() {
  return fmt::format("{:<13} {:<26} {:>9} {:>11}", "file", "what", "vertices", "mismatches");
}

std::string table_line(std::size_t number, const Plate& plate) {
  return fmt::format("{:<13} {:<26} {:>9} {:>11}", file_name(number), plate.what, plate.vertices,
                     plate.mismatches);
}

std::string json_report(const std::vector<Plate>& plates) {
  Json entries = Json::array();
  for (const Plate& plate : plates) {
    entries.push_back({{"file", file_name(entries.size() + 1)},
                       {"vertices", plate.vertices},
                       {"mismatches", plate.mismatches}});
  }
  return Json{{"plates", std::move(entries)}}.dump(2) + "\n";
}

std::string faults(const std::vector<Plate>& plates) {
  std::size_t mismatches = 0;
  bool complete = !plates.empty();
  for (const Plate& plate : plates) {
    mismatches += plate.mismatches;
    complete = complete && plate.vertices > 0;
  }
  if (mismatches > 0) return fmt::format("{} results differ from the model", mismatches);
  return complete ? "" : "a plate without vertices";
}

void write_plates(const fs::path& folder, const std::vector<Plate>& plates) {
  make_folder(folder / "plates");
  make_folder(folder / "reports");
  std::vector<FileContent> files;
  for (const Plate& plate : plates) {
    files.push_back(
        {folder / "plates" / file_name(files.size() + 1), picture::png_bytes(plate.image)});
  }
  files.push_back({folder / "plates" / "plates.png", picture::png_bytes(sheet(plates))});
  files.push_back({folder / "reports" / "plates.json", json_report(plates)});
  write_files(files);
}

}  // namespace hwffd::plates
