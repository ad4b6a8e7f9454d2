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

/// The first of several buffers is the chunk of a GLB; others are files beside it, and what has
/// grown says so.
TEST_F(GltfFiles, SeveralBuffers) {
  GltfModel model = square();
  model.json["bufferViews"][0]["buffer"] = 1;
  model.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};  // which stay
  Json json = Json::parse(model.text("a.bin"));
  json["buffers"].push_back({{"byteLength", model.bytes.size()}, {"uri", "b.bin"}});
  folder.write("a.bin", model.bytes);
  folder.write("b.bin", model.bytes);
  Mesh mesh = load(json.dump(), "in.gltf");
  mesh.save(folder / "same.glb");
  EXPECT_EQ(read_text(folder / "same-1.bin"), model.bytes);
  EXPECT_EQ(Mesh::load(folder / "same.glb").positions(), mesh.positions());
  mesh.set_positions(2 * mesh.positions());
  for (const std::string name : {"out.gltf", "moved.glb"}) {
    SCOPED_TRACE(name);
    mesh.save(folder / name);
    const std::string stem = name.substr(0, name.find('.'));
    EXPECT_EQ(Mesh::load(folder / name).positions(), mesh.positions());
    const std::string text = read_text(folder / name);
    const Json now = name == "out.gltf" ? Json::parse(text) : json_in(text);
    EXPECT_EQ(now["buffers"][1]["uri"], stem + "-1.bin");
    EXPECT_EQ(now["buffers"][1]["byteLength"], model.bytes.size() + 48);
    EXPECT_EQ(read_text(folder / (stem + "-1.bin")).substr(0, 60), model.bytes);
    EXPECT_EQ(now["buffers"][0]["byteLength"], model.bytes.size());
    if (name == "out.gltf") {
      EXPECT_EQ(now["buffers"][0]["uri"], "out.bin");
      EXPECT_EQ(read_text(folder / "out.bin"), model.bytes);
    } else {
      EXPECT_FALSE(now["buffers"][0].contains("uri"));
      EXPECT_EQ(buffer_in(text), model.bytes);
    }
  }
}

/// Chunks of extensions have no place in a .gltf file.
TEST_F(GltfFiles, ChunksThatOnlyAGlbHas) {
  std::string chunks = square().container() + bytes_of<std::uint32_t>({4}) + "XTRAdata";
  const auto length = static_cast<std::uint32_t>(chunks.size());
  std::memcpy(&chunks[8], &length, sizeof(length));
  const Mesh mesh = load(chunks, "a.glb");
  EXPECT_ERROR_PART(mesh.save(folder / "b.gltf"),
                    "it has chunks that only a GLB file can hold; write a .glb");
  EXPECT_EQ(folder.files(), std::set<std::string>{"a.glb"});
}

}  // namespace
}  // namespace hwffd
