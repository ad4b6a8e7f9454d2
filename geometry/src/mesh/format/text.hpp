#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hwffd {

/// Where the text of a file begins: behind the mark (BOM) with which some programs begin UTF-8.
std::size_t text_begin(std::string_view bytes);

/// A number of a text, and half the unit of its last digit.
struct TextNumber {
  double value = 0;
  double half = 0;

  /// Whether binary32 keeps all digits of the text.
  bool is_single() const;
};

/// Reads a whole word as a decimal number; a sign + is taken. A number beyond the range is infinite
/// or 0.
/// @return false for what is none
bool read_number(std::string_view word, TextNumber& number);

/// A whole number.
/// @return false for what is none, or beyond the range of T
template <typename T>
bool read_whole(std::string_view word, T& value);

/// What a message quotes of a file: short enough for one line with the rest of it.
inline constexpr std::size_t kQuoted = 20;

/// The beginning of a text from a file, in quotation marks.
std::string in_quotes(std::string_view text);

/// Reads a number as read_number() does.
/// @throws Error for what is none
TextNumber number_in(std::string_view word);

/// The word with A to Z as a to z.
std::string lower_case(std::string_view word);

/// The shortest decimal that reads back as the value, in binary32 or binary64.
void append_number(std::string& text, double value, bool is_single);

/// Walks over the lines of a text, which end in LF, CR or both, word by word. Words are parted by
/// blanks and tabs; a # that begins a word or follows a number begins a comment, up to the end of
/// the line.
class LineReader {
 public:
  enum class Continuation { kNone, kBackslash };

  /// @param continuation  whether a line that ends in a backslash, outside of a comment, goes on
  LineReader(std::string_view text, Continuation continuation);

  /// Goes to the next line.
  /// @return false at the end
  bool next();

  /// The words of the line; views of the text.
  const std::vector<std::string_view>& words() const { return words_; }
  /// From this word to the last one, or nothing.
  std::string_view from(std::size_t word) const;
  /// Counted from 1; of a line that goes on, its first.
  std::size_t number() const { return number_; }
  /// Behind its end (LF, CR), from the begin of the text.
  std::size_t end() const { return at_; }
  /// What ends the line: "\n", "\r\n" or "\r"; nothing at the end of the text.
  std::string_view ending() const { return ending_; }

 private:
  bool at_ending() const;
  bool at_continuation() const;
  void take_ending();

  std::string_view text_;
  Continuation continuation_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::size_t endings_ = 0;
  std::string_view ending_;
  std::vector<std::string_view> words_;
};

/// A copy of a text in which some parts are replaced, in the order of the text.
class Replacement {
 public:
  explicit Replacement(const std::string& text) : text_(text) { result_.reserve(text.size()); }

  /// Puts `with` in the place of this part, which lies behind all before it.
  void replace(std::string_view part, std::string_view with);
  /// As above; a value that is the one that was read keeps its text, and so does one that is none.
  void replace_number(std::string_view part, double read, double now, bool is_single);
  /// Puts `with` in at this place.
  void insert(std::size_t at, std::string_view with);
  /// With all that follows. For one call, the last.
  std::string take();

 private:
  const std::string& text_;
  std::string result_;
  std::size_t done_ = 0;  ///< of text_
};

}  // namespace hwffd
