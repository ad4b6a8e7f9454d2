#pragma once

namespace hwffd::test {

/// The words of the registers, from the slave of a bus to the register block.
template <class Slave, class Registers>
void connect_words(const Slave& slave, Registers& registers) {
  registers.s_write_valid = slave.m_write_valid;
  registers.s_write_word = slave.m_write_word;
  registers.s_write_data = slave.m_write_data;
  registers.s_write_strobe = slave.m_write_strobe;
  registers.s_read_valid = slave.m_read_valid;
  registers.s_read_word = slave.m_read_word;
}

/// And back.
template <class Registers, class Slave>
void connect_answers(const Registers& registers, Slave& slave) {
  slave.m_write_error = registers.s_write_error;
  slave.m_read_data = registers.s_read_data;
  slave.m_read_error = registers.s_read_error;
}

}  // namespace hwffd::test
