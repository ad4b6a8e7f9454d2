// A core behind registers, a buffer and an interrupt: the sequence of the device `uio` on a
// Verilated hwffd_axi, and what it refuses. That core stands behind CoreAccess, not behind
// /dev/uioN: of the access by Linux's files the reading of folders, the mapping, the refusals and
// what is read and written of interrupts are tested, by files of a folder of the test; a real uioN
// is not.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "device/core_access.hpp"
#include "device/patient_poll.hpp"
#include "device/row_question.hpp"
#include "device/uio_stream.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/registers.h"
#include "hwffd/stream/packets.hpp"
#include "simulated_core.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

/// What is wrong with an access, and what it was used for.
struct Board : test::SimulatedCore {
  using SimulatedCore::SimulatedCore;

  std::uint64_t address = kAddress;
  std::uint64_t bytes = kBytes;
  std::uint32_t wrong_bits = 0;  // of the register there
  std::uint32_t wrong_offset = HWFFD_ID_OFFSET;
  std::uint64_t latest_interrupt = kLatestInterrupt;  // 0: no clock passes
  bool interrupt_is_wired = true;
  int early_interrupts = 0;  // that come before a run has ended
  int interrupts = 0;
};

class SimulatedAccess final : public CoreAccess {
 public:
  explicit SimulatedAccess(Board& board) : board_(board) {}

  std::uint32_t read32(std::uint32_t offset) override {
    return board_.system.read32(offset) ^ (offset == board_.wrong_offset ? board_.wrong_bits : 0);
  }
  void write32(std::uint32_t offset, std::uint32_t value) override {
    board_.system.write32(offset, value);
  }
  std::uint64_t address() const override { return board_.address; }
  std::uint64_t bytes() const override { return board_.bytes; }
  Cures cures() const override { return {"give more", "see to the board"}; }
  void put(std::uint64_t offset, const Words& words) override {
    ASSERT_LE(offset + 16, board_.bytes);
    board_.system.memory.set_beat(board_.address + offset, words);
  }
  Words get(std::uint64_t offset) override {
    EXPECT_LE(offset + 16, board_.bytes);
    return board_.system.memory.beat(board_.address + offset);
  }
  void expect_interrupt() override { EXPECT_FALSE(board_.system.interrupt()); }
  bool wait_interrupt(Milliseconds /*patience*/) override {
    if (board_.early_interrupts > 0) return board_.early_interrupts-- > 0;
    if (!board_.interrupt_within(board_.latest_interrupt)) return false;
    ++board_.interrupts;
    return board_.interrupt_is_wired;
  }

 private:
  Board& board_;
};

UioCore core_of(Board& board, const Configuration* wanted = nullptr) {
  return uio_core("uio:0", std::make_unique<SimulatedAccess>(board), wanted);
}

Lattice moved(const Index3& dims) {
  const Points corners = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();
  return Deformation::parse("random:3").apply(lattice_around("box", corners, dims));
}

std::vector<Embedded> places(std::size_t count, const Index3& dims) {
  std::vector<Embedded> vertices(count);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertices[v].cell[axis] = static_cast<int>((v / (axis + 1)) % (dims[axis] - 3));
    }
    vertices[v].local = Eigen::Vector3d((v % 7) / 7.0, (v % 11) / 11.0, (v % 13) / 13.0);
  }
  return vertices;
}

/// The line with which something is refused.
std::string refusal(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 1);
    return error.what();
  }
  return "nothing was refused";
}

constexpr std::uint64_t kEntryBytes = 16;  // of the ring

const Configuration& fx18() { return find_configuration("basic-fx18-overlapped"); }

TEST(UioDevice, GivesTheBitsOfTheModel) {
  std::size_t rows = 0, compared = 0;
  for (const Configuration& row : configurations()) {
    if (!cores::has_axi_core(row) || !overlaps(row)) continue;
    Board board(row);
    UioCore core = core_of(board);
    StreamDevice device("uio:0", *core.row, std::move(core.stream));
    EXPECT_EQ(device.name(), std::string("uio:0 ") + row.name);
    const std::unique_ptr<Device> model = make_device({"model", row.name});
    const Index3 large{20, 5, 4};  // by pages, in a core that keeps 16 points an axis
    for (const Index3& dims : {Index3{6, 5, 4}, large}) {
      const Lattice lattice = moved(dims);
      const std::vector<Embedded> vertices = places(1100, dims);
      EXPECT_EQ(device.evaluate(lattice, vertices), model->evaluate(lattice, vertices)) << row.name;
      compared += vertices.size();
    }
    const std::vector<Embedded> few = places(100, {6, 5, 4});
    const Device::Tangents got = device.tangents(moved({6, 5, 4}), few);
    const Device::Tangents expected = model->tangents(moved({6, 5, 4}), few);
    EXPECT_EQ(got.positions, expected.positions) << row.name;
    EXPECT_EQ(got.jacobians, expected.jacobians) << row.name;
    compared += few.size();
    const Oracle::Coefficients bspline = Oracle::uniform_bspline();
    std::vector<SupportedVertex> own;
    for (const Embedded& at : few) {
      own.push_back({at.local, moved({6, 5, 4}).support(at.cell)});
    }
    const Device::Blending blending{bspline, bspline, bspline};
    EXPECT_EQ(device.evaluate(own, blending), model->evaluate(own, blending)) << row.name;
    compared += own.size();
    EXPECT_EQ(board.interrupts, 6) << row.name;  // two of the question, one a call
    EXPECT_EQ(board.system.faults(), "") << row.name;
    ++rows;
  }
  EXPECT_GE(rows, 2U);
  EXPECT_EQ(compared, rows * 2400);
}

TEST(UioDevice, MorePacketsThanTheRingHasRoomForGoInSeveralRuns) {
  constexpr std::size_t kPackets = 300;
  Board board(fx18());
  const UioCore core = core_of(board);
  std::vector<Beat> vertices;
  for (std::size_t p = 0; p < kPackets; ++p) {
    append(vertices, vertices_packet({{{static_cast<std::uint32_t>(p << 22), 0, 0}, {}, 7}}));
  }
  const auto nothing = [](double) {};
  const std::unique_ptr<CommandStream> model = model_stream(fx18());
  ASSERT_TRUE(answers_as(*model, fx18()));  // loads what core_of loaded
  const std::vector<Beat> results = core.stream->run(vertices, kPackets, nothing, 1);
  EXPECT_EQ(results.size(), kPackets);
  EXPECT_EQ(results, model->run(vertices, kPackets, nothing, 1));
  EXPECT_EQ(board.interrupts, 2 + 2);
  EXPECT_EQ(board.system.faults(), "");
}

TEST(UioDevice, MoreBeatsThanTheBufferHasRoomForGoInSeveralRuns) {
  Board board(fx18());
  board.bytes = 1 << 20;
  UioCore core = core_of(board);
  StreamDevice device("uio:0", *core.row, std::move(core.stream));
  const std::vector<Embedded> vertices = places(40'000, {6, 5, 4});
  EXPECT_EQ(device.evaluate(moved({6, 5, 4}), vertices),
            make_device({"model", "basic", "fx18"})->evaluate(moved({6, 5, 4}), vertices));
  EXPECT_EQ(board.interrupts, 2 + 2);
  EXPECT_EQ(board.system.faults(), "");
}

// A program ends, and the next one finds windows that are locked and a run that is not read.
TEST(UioDevice, TheNextProgramGoesOn) {
  Board board(fx18());
  const Lattice lattice = moved({4, 4, 4});
  const std::vector<Embedded> vertices = places(20, {4, 4, 4});
  const Points expected = make_device({"model", "basic", "fx18"})->evaluate(lattice, vertices);
  for (int program = 0; program < 3; ++program) {
    UioCore core = core_of(board, &fx18());
    StreamDevice device("uio:0", *core.row, std::move(core.stream));
    EXPECT_EQ(device.evaluate(lattice, vertices), expected);
    board.latest_interrupt = 0;
    EXPECT_EQ(refusal([&] { device.evaluate(lattice, vertices); }),
              "uio:0: a run has not ended after 5 s, 0 of 20 results came");
    board.latest_interrupt = Board::kLatestInterrupt;
    EXPECT_EQ(device.evaluate(lattice, vertices), expected);
  }
  const auto refused_at = [&](std::uint64_t address, std::uint64_t bytes) {
    board.address = address;
    board.bytes = bytes;
    return refusal([&] { core_of(board); });
  };
  const auto text = [](const std::string& address) {
    return "uio:0: its windows are locked, and not around the buffer at " + address +
           "; reset the core";
  };
  constexpr std::uint64_t kHalf = Board::kBytes / 2;
  EXPECT_EQ(refused_at(Board::kAddress + Board::kBytes, kHalf), text("0x140200000"));
  EXPECT_EQ(refused_at(Board::kAddress - kHalf, Board::kBytes), text("0x13ff00000"));
  EXPECT_EQ(refused_at(Board::kAddress, Board::kBytes + kHalf), text("0x140000000"));
  EXPECT_EQ(refused_at(Board::kAddress + kHalf, kHalf), "nothing was refused") << "inside them";
}

// An interrupt that another device on the line raised, or that came late.
TEST(UioDevice, AnInterruptBeforeTheEndOfARunIsWaitedOut) {
  Board board(fx18());
  board.early_interrupts = 3;
  UioCore core = core_of(board);
  EXPECT_EQ(board.early_interrupts, 0);
  StreamDevice device("uio:0", *core.row, std::move(core.stream));
  board.early_interrupts = 2;
  const std::vector<Embedded> vertices = places(20, {4, 4, 4});
  EXPECT_EQ(device.evaluate(moved({4, 4, 4}), vertices),
            make_device({"model", "basic", "fx18"})->evaluate(moved({4, 4, 4}), vertices));
  EXPECT_EQ(board.early_interrupts, 0);
  EXPECT_EQ(board.interrupts, 2 + 1);
}

// A program ends between an error and the look at it, or a bus stops to answer a soft reset: the
// core keeps the error.
TEST(UioDevice, ErrorsOfBeforeAreNotThoseOfARun) {
  Board board(fx18());
  const Lattice lattice = moved({4, 4, 4});
  const std::vector<Embedded> vertices = places(20, {4, 4, 4});
  const Points expected = make_device({"model", "basic", "fx18"})->evaluate(lattice, vertices);
  core_of(board);  // locks the windows
  const std::uint32_t head = board.system.read32(HWFFD_RING_HEAD_OFFSET);
  board.system.memory.set_beat(kEntryBytes * head + board.address, {});  // of a packet of no bytes
  board.system.write32(HWFFD_RING_HEAD_OFFSET, head + 1);
  board.system.write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK);
  board.system.run(1000);
  ASSERT_EQ(board.system.read32(HWFFD_ERROR_STATUS_OFFSET), HWFFD_ERROR_STATUS_DMA_ZERO_MASK);
  UioCore core = core_of(board);
  StreamDevice device("uio:0", *core.row, std::move(core.stream));
  EXPECT_EQ(device.evaluate(lattice, vertices), expected);
}

TEST(UioDevice, RefusesInALine) {
  const auto refused = [](const std::function<void(Board&)>& spoil,
                          const Configuration* wanted = nullptr) {
    Board board(fx18());
    spoil(board);
    return refusal([&] { core_of(board, wanted); });
  };
  EXPECT_EQ(refused([](Board& board) { board.wrong_bits = HWFFD_ID_RESET; }),
            "uio:0: no hwffd here: ID reads 0");
  EXPECT_EQ(refused([](Board& board) {
              board.wrong_offset = HWFFD_VERSION_OFFSET;
              board.wrong_bits = 7U << HWFFD_VERSION_MAJOR_SHIFT;
            }),
            "uio:0: registers of version 7, this driver knows 0");
  EXPECT_EQ(refused([](Board& board) {
              board.wrong_offset = HWFFD_CONFIG_OFFSET;
              board.wrong_bits = 0xF0;
            }),
            "uio:0: its organization and format are no row of the table");
  EXPECT_EQ(refused([](Board& board) {
              board.wrong_offset = HWFFD_CONFIG_OFFSET;
              board.wrong_bits = (18U ^ 32U) << HWFFD_CONFIG_FORMAT_SHIFT;
            }),
            "uio:0: its results are not those of its row");
  EXPECT_EQ(refused([](Board&) {}, &find_configuration("cg1-fx18-overlapped")),
            "uio:0: is not cg1-fx18-overlapped");
  EXPECT_EQ(refused([](Board& board) {
              board.wrong_offset = HWFFD_STATUS_OFFSET;
              board.wrong_bits = HWFFD_STATUS_BUSY_MASK;
            }),
            "uio:0: does not come out of a soft reset; reset the core");
  EXPECT_EQ(refused([](Board& board) {
              board.wrong_offset = HWFFD_RESULT_COUNT_OFFSET;
              board.wrong_bits = 1;
            }),
            "uio:0: 33 of 32 results came, ERROR_STATUS 0x0");
  EXPECT_EQ(refused([](Board& board) { board.bytes = 65536; }),
            "uio:0: its buffer has 65536 bytes, and 1048576 are needed; give more");
  EXPECT_EQ(refused([](Board& board) { board.address += 16; }),
            "uio:0: its buffer is at 0x140000010, which is no multiple of 4096");
  EXPECT_EQ(refused([](Board& board) { board.interrupt_is_wired = false; }),
            "uio:0: a run has ended, but no interrupt came for 5 s; see to the board");
  EXPECT_EQ(refused([](Board& board) { board.latest_interrupt = 0; }),
            "uio:0: a run has not ended after 5 s, 0 of 32 results came");
  EXPECT_EQ(refused([](Board& board) {
              board.system.memory.fail_read(1, 0, cores::kAxiSlverr);
            }).substr(0, 50),
            "uio:0: 0 of 32 results came, ERROR_STATUS 0x8000 a");
}

TEST(UioDevice, APacketThatTheBufferHasNoRoomForIsRefused) {
  Board board(fx18());
  board.bytes = 1 << 20;
  const UioCore core = core_of(board);
  const std::vector<Beat> packet = vertices_packet(std::vector<VertexBeat>(40'000));
  EXPECT_EQ(refusal([&] {
              core.stream->run(
                  packet, 40'000, [](double) {}, 1);
            }),
            "uio:0: its buffer of 1048576 bytes has no room for a packet of 40001 beats and 40000 "
            "results; give more");
}

/// Files that this process has open.
std::ptrdiff_t open_files() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

/// Listens at a path, for one program.
int listen_at(const std::string& path) {
  sockaddr_un place{};
  place.sun_family = AF_UNIX;
  EXPECT_LT(path.size(), sizeof(place.sun_path));
  path.copy(place.sun_path, sizeof(place.sun_path) - 1);
  const int listening = socket(AF_UNIX, SOCK_STREAM, 0);
  EXPECT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&place), sizeof(place)), 0);
  EXPECT_EQ(listen(listening, 1), 0);
  return listening;
}

// A process that listens, and ends before it says what it serves.
TEST(SocketAccess, ThatFailsLeavesNoSocketOpen) {
  const TempFolder folder;
  const std::string path = folder / "core";
  const std::ptrdiff_t before = open_files();
  const int listening = listen_at(path);
  std::thread process([listening] {
    close(accept(listening, nullptr, nullptr));
    close(listening);
  });
  EXPECT_EQ(refusal([&] { socket_access(path); }),
            "socket:" + path + ": the process that serves the core has ended");
  process.join();
  EXPECT_EQ(open_files(), before);
}

TEST(SocketAccess, WithASmallBufferSaysWhoGivesMore) {
  const TempFolder folder;
  const std::string path = folder / "core";
  const int listening = listen_at(path);
  std::thread process([listening] {
    const int client = accept(listening, nullptr, nullptr);
    const std::array<std::uint64_t, 2> buffer{0x40000000, 8192};
    EXPECT_EQ(send(client, &buffer, sizeof(buffer), 0), 16);
    CoreRequest request{};
    while (recv(client, &request, sizeof(request), MSG_WAITALL) == sizeof(request)) {
      const std::uint32_t value = request.offset == HWFFD_ID_OFFSET ? HWFFD_ID_RESET
                                  : request.offset == HWFFD_VERSION_OFFSET
                                      ? HWFFD_VERSION_MAJOR_RESET << HWFFD_VERSION_MAJOR_SHIFT
                                      : 0;
      EXPECT_EQ(request.kind, CoreRequest::kRead);
      EXPECT_EQ(send(client, &value, sizeof(value), 0), 4);
    }
    close(client);
    close(listening);
  });
  EXPECT_EQ(refusal([&] { uio_core("socket:x", socket_access(path), nullptr); }),
            "socket:x: its buffer has 8192 bytes, and 1048576 are needed; start the process that "
            "serves the core with more");
  process.join();
}

/// A timer's signals, a few milliseconds apart, which end every call that waits.
class Signals {
 public:
  Signals() {
    struct sigaction handler {};  // without SA_RESTART
    handler.sa_handler = [](int) {};
    sigaction(SIGALRM, &handler, &before_);
    set(5000);
  }
  ~Signals() {
    set(0);
    sigaction(SIGALRM, &before_, nullptr);
  }

 private:
  static void set(suseconds_t microseconds) {
    const itimerval timer{{0, microseconds}, {0, microseconds}};
    setitimer(ITIMER_REAL, &timer, nullptr);
  }
  struct sigaction before_ {};
};

// Python's handlers and profilers' timers are such.
TEST(PatientPoll, IsEndedByNoSignal) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kShort(40), kLong(20'000);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const Signals signals;
  const auto start = Clock::now();
  EXPECT_EQ(patient_poll(ends[0], POLLIN, kShort), 0);
  EXPECT_GE(Clock::now() - start, kShort);
  EXPECT_EQ(patient_poll(ends[1], POLLOUT, kLong), 1);
  ASSERT_EQ(write(ends[1], "a", 1), 1);
  EXPECT_EQ(patient_poll(ends[0], POLLIN, kLong), 1);
  for (const int end : ends) close(end);
  EXPECT_LT(Clock::now() - start, kLong);
}

/// Folders as Linux has them, with files in place of devices.
class UioFiles : public ::testing::Test {
 protected:
  UioFiles() {
    for (const char* name : {"dev", "uio/uio3/maps/map0", "buffers/udmabuf3"}) {
      std::filesystem::create_directories(folder_ / name);
    }
    write("uio/uio3/maps/map0/size", "0x0000000000001000\n");
    write("buffers/udmabuf3/phys_addr", "0x0000000040000000\n");
    write("buffers/udmabuf3/size", "8192\n");
    write("dev/uio3", std::string(4096, '\1'));
    write("dev/udmabuf3", std::string(8192, '\2'));
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::unique_ptr<CoreAccess> access() {
    return uio_access("3", {folder_ / "dev", folder_ / "uio", folder_ / "buffers"});
  }
  /// Without the name of the folder.
  std::string line() {
    std::string text = refusal([this] { access(); });
    const std::string start = (folder_ / "").string();
    const std::size_t at = text.find(start);
    return at == std::string::npos ? text : text.erase(at, start.size());
  }

  TempFolder folder_;
};

TEST_F(UioFiles, AreMapped) {
  const std::unique_ptr<CoreAccess> board = access();
  EXPECT_EQ(board->address(), 0x40000000U);
  EXPECT_EQ(board->bytes(), 8192U);
  EXPECT_EQ(board->read32(0xFFC), 0x01010101U);
  board->write32(0x10, 0x48464644);
  EXPECT_EQ(board->read32(0x10), 0x48464644U);
  board->put(8176, {1, 2, 3, 4});
  EXPECT_EQ(board->get(8176), (CoreAccess::Words{1, 2, 3, 4}));
  EXPECT_EQ(board->get(0), (CoreAccess::Words{0x02020202, 0x02020202, 0x02020202, 0x02020202}));
  const std::string registers = read_text(folder_ / "dev/uio3");
  EXPECT_EQ(registers.substr(0x0F, 6), std::string("\1DFFH\1"));
  EXPECT_EQ(read_text(folder_ / "dev/udmabuf3").substr(8176),
            std::string("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16));
}

// As Linux has it: 4 bytes that are read count interrupts, 4 that are written enable the next one.
TEST_F(UioFiles, TakeInterruptsByReadingAndWriting) {
  const std::unique_ptr<CoreAccess> board = access();
  board->expect_interrupt();  // reads the 1024 of before
  const std::string one("\1\0\0\0", 4);
  EXPECT_EQ(read_text(folder_ / "dev/uio3"), std::string(4096, '\1') + one);
  EXPECT_FALSE(board->wait_interrupt(CoreAccess::Milliseconds(10)));
  std::ofstream(folder_ / "dev/uio3", std::ios::binary | std::ios::app) << one;
  EXPECT_TRUE(board->wait_interrupt(CoreAccess::Milliseconds(10)));
  EXPECT_FALSE(board->wait_interrupt(CoreAccess::Milliseconds(10)));
}

// A node without an interrupt: Linux refuses what is written.
TEST_F(UioFiles, WithoutAnInterruptSaySo) {
  const int registers = memfd_create("uio3", MFD_ALLOW_SEALING);
  ASSERT_EQ(ftruncate(registers, 4096), 0);
  ASSERT_EQ(fcntl(registers, F_ADD_SEALS, F_SEAL_GROW), 0);
  std::filesystem::remove(folder_ / "dev/uio3");
  std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(registers),
                                  folder_ / "dev/uio3");
  const std::unique_ptr<CoreAccess> board = access();
  EXPECT_EQ(refusal([&] { board->expect_interrupt(); }),
            "uio:3: takes no interrupts: Operation not permitted; does its node in the device "
            "tree name one?");
  close(registers);
}

TEST_F(UioFiles, WithASmallBufferSayWhoGivesMore) {
  std::string registers(4096, '\0');
  const auto set = [&](std::uint32_t offset, std::uint32_t value) {
    for (std::uint32_t byte = 0; byte < 4; ++byte) {
      registers[offset + byte] = static_cast<char>(value >> (8 * byte));
    }
  };
  set(HWFFD_ID_OFFSET, HWFFD_ID_RESET);
  set(HWFFD_VERSION_OFFSET, HWFFD_VERSION_MAJOR_RESET << HWFFD_VERSION_MAJOR_SHIFT);
  write("dev/uio3", registers);
  EXPECT_EQ(refusal([&] { uio_core("uio:3", access(), nullptr); }),
            "uio:3: its buffer has 8192 bytes, and 1048576 are needed; give u-dma-buf more");
}

TEST_F(UioFiles, ThatAreMissingOrWrongAreNamed) {
  write("uio/uio3/maps/map0/size", "0x800\n");
  EXPECT_EQ(line(), "uio/uio3/maps/map0/size: 2048 bytes; the registers take 4096");
  write("uio/uio3/maps/map0/size", "4 KB\n");
  EXPECT_EQ(line(), "uio/uio3/maps/map0/size: 4 bytes; the registers take 4096");
  write("uio/uio3/maps/map0/size", "much\n");
  EXPECT_EQ(line(), "uio/uio3/maps/map0/size: 'much' is no number");
  write("uio/uio3/maps/map0/size", "99999999999999999999\n");
  EXPECT_EQ(line(), "uio/uio3/maps/map0/size: '99999999999999999999' is no number");
  write("uio/uio3/maps/map0/size", "4096\n");
  write("buffers/udmabuf3/size", "0\n");
  EXPECT_EQ(line(), "buffers/udmabuf3/size: 0 bytes; a buffer has 1 to 2^32");
  std::filesystem::remove(folder_ / "buffers/udmabuf3/phys_addr");
  EXPECT_EQ(line(),
            "buffers/udmabuf3/phys_addr: cannot be read; is the buffer in the device tree, "
            "and u-dma-buf loaded?");
  std::filesystem::remove(folder_ / "dev/uio3");
  ASSERT_EQ(mkfifo((folder_ / "dev/uio3").c_str(), 0600), 0);
  EXPECT_EQ(line(), "dev/uio3: its 4096 bytes cannot be mapped: No such device");
  std::filesystem::remove(folder_ / "dev/uio3");
  EXPECT_EQ(line(), "dev/uio3: cannot be opened: No such file or directory");
  std::filesystem::remove_all(folder_ / "uio/uio3");
  EXPECT_EQ(line(),
            "uio/uio3/maps/map0/size: cannot be read; is the core in the device tree, and "
            "uio_pdrv_genirq loaded?");
}

}  // namespace
}  // namespace hwffd
