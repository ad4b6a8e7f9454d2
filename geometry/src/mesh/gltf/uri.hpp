#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hwffd::gltf {

/// The bytes that a URI's %XX stand for. A % without two digits behind it stays: some writers
/// encode nothing.
std::string percent_decoded(std::string_view uri);

/// A relative path as a URI: letters, digits and -._~!$&'()*+,;=@/ stay (RFC 3986), so do letters
/// beyond ASCII, since glTF takes IRIs (glTF 2.0, section 2.8); other bytes become %XX. A colon
/// does, too: in a first name it would end a scheme.
std::string percent_encoded(std::string_view path);

/// Whether a URI names something without the help of a folder: "data:...", "https://...", "/a".
bool is_absolute_uri(std::string_view uri);

/// The URI of the same file for who looks from the folder of another file (relocated()); as it is
/// if it is absolute, or both are one folder.
/// @param folder  that the URI starts from
std::string relocated_uri(const std::string& uri, const std::filesystem::path& folder,
                          const std::filesystem::path& output);

/// The bytes of a "data:TYPE;base64,..." URI.
/// @return nothing for any other, and for what is not base64
std::optional<std::string> data_of(std::string_view uri);

/// The same URI with other bytes: what stands before the comma stays.
std::string with_data(std::string_view uri, std::string_view bytes);

}  // namespace hwffd::gltf
