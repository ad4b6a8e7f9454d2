// ffd_axil_slave between a master that offers and takes at random times, or takes a response only
// when it is there, and words whose answer changes in every clock.
#include <gtest/gtest.h>

#include <deque>

#include "Vaxil_slave.h"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

struct Response {
  bool error;
  std::uint32_t data;
};

/// What is inside, and what was right of it.
class Slave {
 public:
  Slave() {
    dut().rst = 1;
    for (int i = 0; i < 3; ++i) sim_.tick();
    dut().rst = 0;
  }

  /// A clock. `patient`: a response is taken only when it is there.
  void tick(double rate, bool patient) {
    offer(rate);
    dut().s_axil_bready = (!patient || dut().s_axil_bvalid != 0) && random_.chance(0.5);
    dut().s_axil_rready = (!patient || dut().s_axil_rvalid != 0) && random_.chance(0.5);
    dut().m_write_error = random_.chance(0.3);
    dut().m_read_error = random_.chance(0.3);
    dut().m_read_data = random_.word();
    dut().eval();
    const bool offered = (dut().s_axil_awvalid | dut().s_axil_wvalid | dut().s_axil_arvalid) != 0;
    EXPECT_EQ(dut().m_awake != 0, offered || busy());
    words();
    responses();
    const bool aw = (dut().s_axil_awvalid & dut().s_axil_awready) != 0;
    const bool w = (dut().s_axil_wvalid & dut().s_axil_wready) != 0;
    const bool ar = (dut().s_axil_arvalid & dut().s_axil_arready) != 0;
    if (aw) addresses_.push_back(dut().s_axil_awaddr >> 2);
    if (w) data_.push_back({dut().s_axil_wdata, dut().s_axil_wstrb});
    if (ar) reads_.push_back(dut().s_axil_araddr >> 2);
    sim_.tick();
    if (aw) dut().s_axil_awvalid = 0;
    if (w) dut().s_axil_wvalid = 0;
    if (ar) dut().s_axil_arvalid = 0;
  }

  bool busy() const {
    return !addresses_.empty() || !data_.empty() || !reads_.empty() || !written_.empty() ||
           !read_.empty();
  }
  int writes = 0, reads = 0;

 private:
  struct Data {
    std::uint32_t word;
    unsigned strobe;
  };

  Vaxil_slave& dut() { return sim_.dut(); }

  /// What is offered stays until it is taken.
  void offer(double rate) {
    if (dut().s_axil_awvalid == 0 && random_.chance(rate)) {
      dut().s_axil_awvalid = 1;
      dut().s_axil_awaddr = random_.word() & 0xFFF;
      dut().s_axil_awprot = random_.word() & 7;
    }
    if (dut().s_axil_wvalid == 0 && random_.chance(rate)) {
      dut().s_axil_wvalid = 1;
      dut().s_axil_wdata = random_.word();
      dut().s_axil_wstrb = random_.word() & 0xF;
    }
    if (dut().s_axil_arvalid == 0 && random_.chance(rate)) {
      dut().s_axil_arvalid = 1;
      dut().s_axil_araddr = random_.word() & 0xFFF;
      dut().s_axil_arprot = random_.word() & 7;
    }
  }

  void words() {
    if (dut().m_write_valid != 0) {
      ASSERT_FALSE(addresses_.empty() || data_.empty());
      EXPECT_EQ(dut().m_write_word, addresses_.front());
      EXPECT_EQ(dut().m_write_data, data_.front().word);
      EXPECT_EQ(dut().m_write_strobe, data_.front().strobe);
      addresses_.pop_front();
      data_.pop_front();
      written_.push_back({dut().m_write_error != 0, 0});
    }
    if (dut().m_read_valid != 0) {
      ASSERT_FALSE(reads_.empty());
      EXPECT_EQ(dut().m_read_word, reads_.front());
      reads_.pop_front();
      const bool error = dut().m_read_error != 0;
      read_.push_back({error, error ? 0 : dut().m_read_data});
    }
  }

  void responses() {
    if (dut().s_axil_bvalid != 0) {
      ASSERT_FALSE(written_.empty());
      EXPECT_EQ(dut().s_axil_bresp, written_.front().error ? 2 : 0);
      if (dut().s_axil_bready != 0) {
        written_.pop_front();
        ++writes;
      }
    }
    if (dut().s_axil_rvalid != 0) {
      ASSERT_FALSE(read_.empty());
      EXPECT_EQ(dut().s_axil_rresp, read_.front().error ? 2 : 0);
      EXPECT_EQ(dut().s_axil_rdata, read_.front().data);
      if (dut().s_axil_rready != 0) {
        read_.pop_front();
        ++reads;
      }
    }
  }

  tb::Sim<Vaxil_slave> sim_{1};
  tb::Random random_{3};
  std::deque<std::uint32_t> addresses_, reads_;  ///< taken, not yet handed on
  std::deque<Data> data_;
  std::deque<Response> written_, read_;  ///< handed on, not yet answered
};

TEST(Slave, AnswersWhateverTheMasterDoes) {
  Slave slave;
  for (const bool patient : {false, true}) {
    for (const double rate : {1.0, 0.3, 0.02}) {
      const int writes = slave.writes, reads = slave.reads;
      for (int clock = 0; clock < 3000; ++clock) slave.tick(rate, patient);
      EXPECT_GT(slave.writes - writes, 20) << rate;
      EXPECT_GT(slave.reads - reads, 20) << rate;
    }
  }
}

}  // namespace
}  // namespace hwffd::test
