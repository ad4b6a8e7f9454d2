#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plates/plate.hpp"

namespace hwffd::plates {

/// "plate01.png" for plate 1.
std::string file_name(std::size_t number);

/// One line of the table; `header` is the line above.
std::string table_header();
std::string table_line(std::size_t number, const Plate& plate);

/// build/reports/plates.json: {"plates": [{"file", "vertices", "mismatches"}]}.
std::string json_report(const std::vector<Plate>& plates);

/// One line if results differ from the model or a plate has none; empty if all is well.
std::string faults(const std::vector<Plate>& plates);

/// Writes pictures and report below a folder, all or none: plates/plate01.png and so on;
/// plates/plates.png, all of them an eighth as wide on one sheet; reports/plates.json.
/// @param plates  of one size, its sides multiples of 8
/// @throws Error if they cannot be written
void write_plates(const std::filesystem::path& folder, const std::vector<Plate>& plates);

}  // namespace hwffd::plates
