// The files that a glTF consists of, on their way to another name, folder or container.

#include <gtest/gtest.h>

#include <cstring>

#include "errors.hpp"
#include "gltf_model.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using GltfFiles = MeshFiles;

/// The buffer of the output has the output's name, and no buffer of the input is touched.
TEST_F(GltfFiles, BuffersBesideIt) {
  const GltfModel model = square();
  std::filesystem::create_directory(folder / "out");
  folder.write("shared.bin", model.bytes);
  Mesh mesh = load(model.text("shared.bin"), "src.gltf");
  mesh.set_positions(2 * mesh.positions());
  for (const std::string name : {"shared.gltf", "./shared.gltf", "out/../shared.gltf"}) {
    const std::string message = message_of<Error>([&] { mesh.save(folder / name); });
    expect_part(message, "shared.bin");
  }
  EXPECT_EQ(read_text(folder / "shared.bin"), model.bytes);
  EXPECT_EQ(folder.files().count("shared.gltf"), 0u);
  for (const auto& [name, uri] :
       std::vector<std::pair<std::string, std::string>>{{"dst.gltf", "dst.bin"},
                                                        {"a 10%.gltf", "a%2010%25.bin"},
                                                        {"out/shared.gltf", "shared.bin"}}) {
    mesh.save(folder / name);
    EXPECT_EQ(Json::parse(read_text(folder / name))["buffers"][0]["uri"], uri);
    EXPECT_EQ(Mesh::load(folder / name).positions(), mesh.positions());
  }
  EXPECT_EQ(read_text(folder / "shared.bin"), model.bytes);
  // A copy of it elsewhere, under the same name, is the same to the byte.
  const Mesh same = Mesh::load(folder / "src.gltf");
  same.save(folder / "out/shared.gltf");
  EXPECT_EQ(read_text(folder / "out/shared.gltf"), read_text(folder / "src.gltf"));
  EXPECT_EQ(read_text(folder / "out/shared.bin"), model.bytes);
}

/// Names of other files are true from the output's folder.
TEST_F(GltfFiles, NamesAreFoundFromAnotherFolder) {
  for (const char* name : {"in", "out"}) std::filesystem::create_directory(folder / name);
  GltfModel model = square();
  const std::string data = "data:image/png;base64,AAAA";
  model.json["images"] = {{{"uri", "skin/my%20red.png"}},
                          {{"uri", data}},
                          {{"uri", "/abs.png"}},
                          {{"uri", "https://example.org/a.png"}}};
  model.json["extensions"]["EXT_lights_ies"]["lights"] = {{{"uri", "lamp.ies"}}};
  model.json["extras"]["uri"] = "lamp.ies";
  folder.write("in/a.gltf", model.text());
  Mesh::load(folder / "in/a.gltf").save(folder / "out/a.gltf");
  const Json json = Json::parse(read_text(folder / "out/a.gltf"));
  EXPECT_EQ(json["images"][0]["uri"], "../in/skin/my%20red.png");
  EXPECT_EQ(json["images"][1]["uri"], data);
  EXPECT_EQ(json["images"][2]["uri"], "/abs.png");
  EXPECT_EQ(json["images"][3]["uri"], "https://example.org/a.png");
  EXPECT_EQ(json["extensions"]["EXT_lights_ies"]["lights"][0]["uri"], "../in/lamp.ies");
  EXPECT_EQ(json["extras"]["uri"], "lamp.ies");
  Mesh::load(folder / "in/a.gltf").save(folder / "in/b.gltf");
  EXPECT_EQ(read_text(folder / "in/b.gltf"), model.text());
}

/// Both containers hold the same.
TEST_F(GltfFiles, FromOneContainerToTheOther) {
  const GltfModel model = adorned();
  folder.write("a.bin", model.bytes);
  for (const std::string& text : {model.text(), model.text("a.bin")}) {
    load(text, "a.gltf").save(folder / "b.glb");
    const std::string container = read_text(folder / "b.glb");
    EXPECT_EQ(buffer_in(container).substr(0, model.bytes.size()), model.bytes);
    EXPECT_EQ(json_in(container), json_in(model.container()));
    std::uint32_t length = 0;
    std::memcpy(&length, &container[8], sizeof(length));
    EXPECT_EQ(length, container.size());
    Mesh::load(folder / "b.glb").save(folder / "c.gltf");
    EXPECT_EQ(Json::parse(read_text(folder / "c.gltf")), Json::parse(model.text("c.bin")));
    EXPECT_EQ(read_text(folder / "c.bin"), model.bytes);
  }
}

}  // namespace
}  // namespace hwffd
