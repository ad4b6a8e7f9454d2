// Made from rtl/formats.csv by tools/tables/generated_files.py; changes here are lost.
#pragma once

namespace hwffd {

/// What coordinates and points are on the stream.
enum class Words {
  kFloat,  ///< binary32
  kBlock,  ///< binary32, with one exponent for the points of a lattice inside
  kFixed   ///< fixed point
};

/// A number format of the core.
struct Format {
  const char* name;
  int number;  ///< the parameter FORMAT
  Words words;
  int width;  ///< bits of a word
};

/// Every format.
// clang-format off
constexpr Format kFormats[] = {
    {"fp32", 0, Words::kFloat, 32},
    {"bfp32", 99, Words::kBlock, 32},
    {"fx12", 12, Words::kFixed, 12},
    {"fx13", 13, Words::kFixed, 13},
    {"fx14", 14, Words::kFixed, 14},
    {"fx15", 15, Words::kFixed, 15},
    {"fx16", 16, Words::kFixed, 16},
    {"fx17", 17, Words::kFixed, 17},
    {"fx18", 18, Words::kFixed, 18},
    {"fx19", 19, Words::kFixed, 19},
    {"fx20", 20, Words::kFixed, 20},
    {"fx21", 21, Words::kFixed, 21},
    {"fx22", 22, Words::kFixed, 22},
    {"fx23", 23, Words::kFixed, 23},
    {"fx24", 24, Words::kFixed, 24},
    {"fx25", 25, Words::kFixed, 25},
    {"fx26", 26, Words::kFixed, 26},
    {"fx27", 27, Words::kFixed, 27},
    {"fx28", 28, Words::kFixed, 28},
    {"fx29", 29, Words::kFixed, 29},
    {"fx30", 30, Words::kFixed, 30},
    {"fx31", 31, Words::kFixed, 31},
    {"fx32", 32, Words::kFixed, 32},
};
// clang-format on

/// The same in words, for messages.
constexpr const char* kFormatNames = "fp32, bfp32, or fx12 to fx32";

}  // namespace hwffd
