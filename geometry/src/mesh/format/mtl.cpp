#include "mesh/format/mtl.hpp"

#include <assimp/ObjMaterial.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesh/format/text.hpp"

namespace hwffd {
namespace {

/// A key of aiMaterial: its name, and the kind and number of a texture.
struct Key {
  const char* name;
  unsigned type;
  unsigned index;
};

const std::map<std::string, Key>& colours() {
  static const std::map<std::string, Key> kColours = {{"ka", {AI_MATKEY_COLOR_AMBIENT}},
                                                      {"kd", {AI_MATKEY_COLOR_DIFFUSE}},
                                                      {"ks", {AI_MATKEY_COLOR_SPECULAR}},
                                                      {"ke", {AI_MATKEY_COLOR_EMISSIVE}},
                                                      {"tf", {AI_MATKEY_COLOR_TRANSPARENT}}};
  return kColours;
}

const std::map<std::string, Key>& factors() {
  static const std::map<std::string, Key> kFactors = {{"ns", {AI_MATKEY_SHININESS}},
                                                      {"d", {AI_MATKEY_OPACITY}},
                                                      {"ni", {AI_MATKEY_REFRACTI}},
                                                      {"pr", {AI_MATKEY_ROUGHNESS_FACTOR}},
                                                      {"pm", {AI_MATKEY_METALLIC_FACTOR}}};
  return kFactors;
}

const std::map<std::string, aiTextureType>& pictures() {
  static const std::map<std::string, aiTextureType> kPictures = {
      {"map_kd", aiTextureType_DIFFUSE},
      {"map_ka", aiTextureType_AMBIENT},
      {"map_ks", aiTextureType_SPECULAR},
      {"map_ke", aiTextureType_EMISSIVE},
      {"map_emissive", aiTextureType_EMISSIVE},
      {"map_d", aiTextureType_OPACITY},
      {"map_ns", aiTextureType_SHININESS},
      {"map_bump", aiTextureType_HEIGHT},
      {"bump", aiTextureType_HEIGHT},
      {"norm", aiTextureType_NORMALS},
      {"map_kn", aiTextureType_NORMALS},
      {"disp", aiTextureType_DISPLACEMENT},
      {"map_disp", aiTextureType_DISPLACEMENT},
      {"refl", aiTextureType_REFLECTION},
      {"map_pr", aiTextureType_DIFFUSE_ROUGHNESS},
      {"map_pm", aiTextureType_METALNESS}};
  return kPictures;
}

/// How many words follow an option of a texture; -1 if it is none.
int words_of_option(const std::string& option) {
  static const std::map<std::string, int> kWords = {
      {"-blendu", 1}, {"-blendv", 1},  {"-boost", 1}, {"-bm", 1}, {"-cc", 1},
      {"-clamp", 1},  {"-imfchan", 1}, {"-mm", 2},    {"-o", 3},  {"-s", 3},
      {"-t", 3},      {"-texres", 1},  {"-type", 1}};
  const auto it = kWords.find(option);
  return it == kWords.end() ? -1 : it->second;
}

void put(aiMaterial& material, const Key& key, const aiColor3D& colour) {
  material.AddProperty(&colour, 1, key.name, key.type, key.index);
}

void put(aiMaterial& material, const Key& key, float value) {
  material.AddProperty(&value, 1, key.name, key.type, key.index);
}

void put_name(aiMaterial& material, const std::string& name) {
  const aiString text(name);
  material.AddProperty(&text, AI_MATKEY_NAME);
}

void put_illumination(aiMaterial& material, int model) {
  const int shading = model == 0   ? aiShadingMode_NoShading
                      : model == 2 ? aiShadingMode_Phong
                                   : aiShadingMode_Gouraud;
  material.AddProperty(&shading, 1, AI_MATKEY_SHADING_MODEL);
  material.AddProperty(&model, 1, AI_MATKEY_OBJ_ILLUM);
}

/// What a material is before its statements.
std::unique_ptr<aiMaterial> plain_material(const std::string& name) {
  constexpr float kGrey = 0.6f;
  auto material = std::make_unique<aiMaterial>();
  put_name(*material, name);
  put_illumination(*material, 1);
  for (const auto& [statement, key] : colours()) put(*material, key, aiColor3D(0, 0, 0));
  put(*material, colours().at("kd"), aiColor3D(kGrey, kGrey, kGrey));
  put(*material, colours().at("tf"), aiColor3D(1, 1, 1));
  put(*material, factors().at("ns"), 0.0f);
  put(*material, factors().at("d"), 1.0f);
  put(*material, factors().at("ni"), 1.0f);
  return material;
}

class MtlReader {
 public:
  std::vector<MtlMaterial> read(std::string_view text) {
    LineReader lines(text, LineReader::Continuation::kBackslash);
    while (lines.next()) {
      if (lines.words().empty()) continue;
      const std::string statement = lower_case(lines.words()[0]);
      if (statement == "newmtl") {
        const std::string name(lines.from(1));
        materials_.push_back({name, plain_material(name), {}});
      } else if (!materials_.empty()) {
        take(lines, statement);
      }
    }
    return std::move(materials_);
  }

 private:
  void take(const LineReader& lines, const std::string& statement) {
    MtlMaterial& last = materials_.back();
    const std::vector<std::string_view>& words = lines.words();
    float value = 0;
    if (colours().count(statement) != 0 && take_colour(words, colours().at(statement))) return;
    if (pictures().count(statement) != 0) {
      take_picture(lines, pictures().at(statement));
      return;
    }
    const bool is_number = words.size() == 2 && number_in(words[1], value);
    if (is_number && factors().count(statement) != 0) {
      put(*last.material, factors().at(statement), value);
    } else if (is_number && statement == "tr") {
      put(*last.material, factors().at("d"), 1.0f - value);
    } else if (is_number && statement == "illum") {
      put_illumination(*last.material, static_cast<int>(std::clamp(value, 0.0f, 100.0f)));
    } else {
      last.extras.emplace_back(words[0]);
    }
  }

  static bool number_in(std::string_view word, float& value) {
    TextNumber number;
    if (!read_number(word, number)) return false;
    value = static_cast<float>(number.value);
    return true;
  }

  /// One number is a grey.
  bool take_colour(const std::vector<std::string_view>& words, const Key& key) {
    float rgb[3] = {0, 0, 0};
    if (words.size() != 2 && words.size() < 4) return false;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!number_in(words[words.size() == 2 ? 1 : 1 + c], rgb[c])) return false;
    }
    put(*materials_.back().material, key, aiColor3D(rgb[0], rgb[1], rgb[2]));
    return true;
  }

  /// Options, and behind them the name of a file, which may have blanks.
  void take_picture(const LineReader& lines, aiTextureType type) {
    MtlMaterial& last = materials_.back();
    const std::vector<std::string_view>& words = lines.words();
    std::size_t w = 1;
    while (w + 1 < words.size() && words_of_option(lower_case(words[w])) > 0) {
      const std::string option = lower_case(words[w]);
      last.extras.push_back(option + " of " + std::string(words[0]));
      std::size_t values = static_cast<std::size_t>(words_of_option(option));
      float ignored = 0;
      const bool may_be_fewer = values > 1;
      for (++w; values > 0 && w + 1 < words.size(); --values, ++w) {
        if (may_be_fewer && !number_in(words[w], ignored)) break;
      }
    }
    const aiString name{std::string(lines.from(w))};
    last.material->AddProperty(&name, AI_MATKEY_TEXTURE(type, 0));
  }

  std::vector<MtlMaterial> materials_;
};

}  // namespace

std::unique_ptr<aiMaterial> default_material() { return plain_material(AI_DEFAULT_MATERIAL_NAME); }

std::unique_ptr<aiMaterial> named_material(const std::string& name) { return plain_material(name); }

std::vector<std::string> mtl_differences(const aiMaterial& material, const aiMaterial& other) {
  constexpr float kRounding = 1e-3f;  // of a colour or factor on its way through another format
  const std::unique_ptr<aiMaterial> plain = plain_material("");
  std::vector<std::string> differences;
  const auto differ = [](const aiColor4D& a, const aiColor4D& b) {
    const float most = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    return !(most <= kRounding * std::max({1.0f, a.r, a.g, a.b}));
  };
  const auto compare = [&](const std::string& statement, const Key& key) {
    const auto value_in = [&](const aiMaterial& which) {
      aiColor4D value(0, 0, 0, 0);
      if (which.Get(key.name, key.type, key.index, value) != aiReturn_SUCCESS) {
        value.r = std::numeric_limits<float>::quiet_NaN();
      }
      return value;
    };
    const aiColor4D here = value_in(material);
    const bool is_plain = std::isnan(here.r) || !differ(here, value_in(*plain));
    if (!is_plain && differ(here, value_in(other))) differences.push_back(statement);
  };
  for (const auto& [statement, key] : colours()) compare(statement, key);
  for (const auto& [statement, key] : factors()) compare(statement, key);
  std::set<aiTextureType> seen;
  for (const auto& [statement, type] : pictures()) {
    if (!seen.insert(type).second) continue;
    if (material.GetTextureCount(type) > other.GetTextureCount(type)) {
      differences.push_back(statement);
    }
  }
  return differences;
}

std::vector<MtlMaterial> read_mtl(std::string_view text) { return MtlReader().read(text); }

}  // namespace hwffd
