#include "mesh/obj_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <string_view>

#include "mesh/read_scene.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::uint32_t kDigit = 1 << 20;  // a number is two of them: each is exact in binary32

aiVector3D coded(std::uint32_t number) {
  return {static_cast<float>(number % kDigit), static_cast<float>(number / kDigit), 0};
}

std::uint32_t decoded(const aiVector3D& position) {
  return static_cast<std::uint32_t>(position.x) + kDigit * static_cast<std::uint32_t>(position.y);
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t start = text.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(kBlanks, start), text.size());
    words.push_back(text.substr(start, end - start));
    text.remove_prefix(end);
  }
}

template <typename T>
std::errc parse(std::string_view word, T& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

/// False where the word is no number; one too large for binary32 is infinite.
bool read_number(std::string_view word, float& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const std::errc error = parse(word, value);
  if (error != std::errc::result_out_of_range) return error == std::errc();
  double wide = 0;
  if (parse(word, wide) == std::errc::result_out_of_range) {
    const bool is_small = word.find_first_of("eE") != word.npos && word.find("-", 1) != word.npos;
    wide = is_small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  value = static_cast<float>(wide);
  return true;
}

/// Lines that end in a backslash go on in the next.
std::string without_continuations(std::string text) {
  for (std::size_t at = text.find('\\'); at != text.npos; at = text.find('\\', at + 1)) {
    const std::size_t next = text.compare(at + 1, 1, "\r") == 0 ? at + 2 : at + 1;
    if (text.compare(next, 1, "\n") == 0) text.replace(at, next + 1 - at, next + 1 - at, ' ');
  }
  return text;
}

/// Whether there are faces, lines or points. A file without is a cloud of points: nothing else in
/// it is tied to them, and some of it keeps Assimp from reading them.
bool uses_vertices(const std::string& text) {
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size()) + 1) {
    if (text[at] == 'f' || text[at] == 'l' || text[at] == 'p') return true;
  }
  return false;
}

template <typename T>
void grow(T*& data, unsigned old_size, unsigned size, const T& value) {
  if (data == nullptr) return;
  T* const grown = new T[size];
  std::fill(std::copy_n(data, old_size, grown), grown + size, value);
  delete[] data;
  data = grown;
}

}  // namespace

ObjVertices::ObjVertices(const std::string& bytes) {
  const std::string text = without_continuations(bytes);
  const bool has_faces = uses_vertices(text);
  numbered_.reserve(text.size());
  std::size_t number_of_line = 0;
  for (std::size_t at = 0; at < text.size();) {
    ++number_of_line;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    if (line.size() > 1 && line[0] == 'v' && (line[1] == ' ' || line[1] == '\t')) {
      numbered_ += take(line.substr(1), number_of_line) + '\n';
    } else if (has_faces) {
      numbered_.append(line).append(1, '\n');
    }
    at = end + 1;
  }
  numbered_ += "# Assimp takes no file that is very short.\n";
}

std::string ObjVertices::take(std::string_view line, std::size_t number_of_line) {
  const std::vector<std::string_view> words = words_of(line.substr(0, line.find('#')));
  std::array<float, 4> values{0, 0, 0, 1};
  bool good = words.size() >= 3;
  for (std::size_t w = 0; good && w < 3; ++w) good = read_number(words[w], values[w]);
  if (good && words.size() == 4) good = read_number(words[3], values[3]) && values[3] != 0;
  if (!good) {
    throw not_a_mesh(fmt::format("line {}: a vertex is not three numbers", number_of_line));
  }
  const auto number = static_cast<std::uint32_t>(positions_.size());
  positions_.emplace_back(values[0] / values[3], values[1] / values[3], values[2] / values[3]);
  std::string result = fmt::format("v {} {} 0", number % kDigit, number / kDigit);
  if (words.size() == 6) result += fmt::format(" {} {} {}", words[3], words[4], words[5]);
  return result;
}

void ObjVertices::add_unused(aiScene& scene) const {
  std::vector<bool> used(positions_.size(), false);
  each_part(scene, [&](const aiMesh& part, std::size_t) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) used.at(decoded(part.mVertices[v])) = true;
  });
  const auto missing = static_cast<unsigned>(std::count(used.begin(), used.end(), false));
  if (missing == 0) return;
  aiMesh& part = *scene.mMeshes[0];
  const unsigned first = part.mNumVertices;
  part.mNumVertices += missing;
  grow(part.mVertices, first, part.mNumVertices, aiVector3D());
  grow(part.mNormals, first, part.mNumVertices, aiVector3D(0, 1, 0));
  for (aiVector3D*& data : part.mTextureCoords) grow(data, first, part.mNumVertices, aiVector3D());
  for (aiColor4D*& data : part.mColors) grow(data, first, part.mNumVertices, aiColor4D(1, 1, 1, 1));
  unsigned v = first;
  for (std::uint32_t number = 0; number < used.size(); ++number) {
    if (!used[number]) part.mVertices[v++] = coded(number);
  }
}

std::vector<std::uint32_t> ObjVertices::restore(aiScene& scene) const {
  add_unused(scene);
  std::vector<std::uint32_t> numbers;
  each_part(scene, [&](aiMesh& part, std::size_t) {
    std::vector<unsigned> order(part.mNumVertices);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
      return decoded(part.mVertices[a]) < decoded(part.mVertices[b]);
    });
    reorder(part, order);
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      numbers.push_back(decoded(part.mVertices[v]));
      part.mVertices[v] = positions_[numbers.back()];
    }
  });
  return numbers;
}

}  // namespace hwffd
