#include "emission/c/translate_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "emission/c_family_syntax.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::c {
namespace {

constexpr std::string_view kSines = "Sines";
constexpr const char* kInlined = "TREELINE_LINK_INLINE";

[[noreturn]] void reject(std::string_view text) {
  throw std::logic_error(fmt::format("loops over links: not to be had in C: {}", text));
}

/// Reads what stands between the bracket at `at` and the one that closes it, behind which it stops,
/// split at its commas.
std::vector<std::string> read_list(std::string_view text, std::size_t& at) {
  std::vector<std::string> items(1);
  int depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    const bool opens = std::string_view("([{<").find(c) != std::string_view::npos;
    const bool closes = std::string_view(")]}>").find(c) != std::string_view::npos;
    if (closes && --depth == 0) {
      ++at;
      return items.front().empty() ? std::vector<std::string>() : items;
    }
    if (depth == 1 && c == ',') {
      items.emplace_back();
    } else if (depth > 0 && !(c == ' ' && items.back().empty())) {
      items.back() += c;
    }
    if (opens) ++depth;
  }
  reject(text);
}

std::vector<std::string> split_list(std::string_view list) {
  const std::string text = fmt::format("({})", list);
  std::size_t at = 0;
  return read_list(text, at);
}

std::string joined(const std::vector<std::string>& items) {
  std::string list;
  for (const std::string& item : items) {
    if (!item.empty()) list += (list.empty() ? "" : ", ") + item;
  }
  return list;
}

/// A line without its blanks.
struct Line {
  std::size_t indentation;
  std::string code, note;
};

Line split_line(const std::string& line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t at = line.find("//");
  std::string code = line.substr(begin, at == line.npos ? at : at - begin);
  while (code.ends_with(' ')) code.pop_back();
  return {begin, code, at == line.npos ? "" : line.substr(at)};
}

/// A member of a struct whose bounds are constants of the robot, without its default value.
std::string name_bounds(const std::string& member, const std::string& prefix) {
  static const std::regex bound("\\b(links|slots|turned|points|rows|ranked|base_entries)\\b");
  static const std::regex default_value(" = [^;]*;");
  const std::size_t open = member.find('[');
  const std::string rest =
      std::regex_replace(member.substr(open == member.npos ? 0 : open), default_value, ";");
  if (open == member.npos) return rest;
  std::string named = member.substr(0, open);
  std::size_t from = 0;
  for (std::sregex_iterator at(rest.begin(), rest.end(), bound), end; at != end; ++at) {
    const auto place = static_cast<std::size_t>(at->position());
    named += rest.substr(from, place - from) + prefix + in_capitals(at->str());
    from = place + at->str().size();
  }
  return named + rest.substr(from);
}

/// Lines of at most 100 columns, in which a pointer's type and its name stay together.
std::string wrap_statements(const std::string& code, std::size_t indentation) {
  static const std::regex pointer("(\\w\\*) ");
  std::istringstream lines(std::regex_replace(code, pointer, "$1\t"));
  std::string text;
  for (std::string line; std::getline(lines, line);) text += wrap_line(line, indentation);
  std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

/// A statement with its comment, which takes a line of its own where both are too long for one.
std::string print_lines(const std::string& code, const std::string& note, std::size_t indentation) {
  if (code.empty() && note.empty()) return {};
  if (code.empty()) return std::string(indentation, ' ') + note + "\n";
  if (note.empty()) return wrap_statements(code, indentation);
  const std::string line = fmt::format("{}{}  {}\n", std::string(indentation, ' '), code, note);
  if (line.size() <= 101) return line;
  return std::string(indentation, ' ') + note + "\n" + wrap_statements(code, indentation);
}

}  // namespace

LoopTranslator::LoopTranslator(const EmissionContext& context, const LoopTable& table,
                               bool given_sines)
    : name_(context.name + "_loops_"),
      capitals_(name_in_capitals(context) + "_LOOPS_"),
      number_(number_type(context)),
      suffix_(context.single_precision ? "F" : ""),
      table_{{"Floats", table.floats},   {"Sliding", table.sliding}, {"Driven", table.driven},
             {"Rubbing", table.rubbing}, {"Coupled", table.coupled}, {"OwnSines", table.own_sines},
             {"Balls", table.balls},     {"Pushed", table.pushed},   {"Loaded", table.loaded},
             {"Sorted", table.sorted},   {"Stepped", table.stepped}, {"Grounded", table.grounded},
             {"Freed", table.freed},     {"Turning", table.turning}},
      given_sines_(given_sines) {
  const std::pair<const char*, const char*> works[] = {
      {"Table", "link_table"},     {"Poses", "link_poses"},
      {"Motions", "motion_work"},  {"Inertias", table.coupled ? "matrix_work" : "inertia_work"},
      {"Matrices", "matrix_work"}, {"Rows", "row_work"}};
  for (const auto& [parameter, work] : works) types_[parameter] = name_ + work;
}

std::string LoopTranslator::translate(const LoopItem& item) {
  if (item.is_struct() && item.head.ends_with(kSines)) return {};  // they are arguments, or none
  return item.comment + (item.is_struct() ? translate_struct(item) : translate_function(item));
}

std::string LoopTranslator::translate_struct(const LoopItem& item) {
  const std::string name = item.name();
  types_[name] = name_ + in_snake_case(name);
  structs_.clear();
  numbers_.clear();
  std::string text = "typedef struct {\n";
  for (const std::string& member : join_statements(item.body)) {
    const auto [indentation, code, note] = split_line(member);
    if (code.starts_with("using ") || code.starts_with("static constexpr ")) continue;
    text += print_lines(rewrite(name_bounds(code, capitals_)), note, indentation);
  }
  return text + fmt::format("}} {};\n", types_[name]);
}

std::string LoopTranslator::type(const std::string& name) const {
  if (name == "Real") return number_;
  const auto found = types_.find(name.substr(0, name.find('<')));
  if (found == types_.end()) reject(name);
  return found->second;
}

LoopParameter LoopTranslator::parameter(const std::string& text) const {
  static const std::regex array("(const )?Real \\(&(\\w+)\\)\\[(\\d+)\\]");
  static const std::regex reference("(const )?([\\w<>]+)& (\\w+)");
  static const std::regex value("(const )?([\\w<>]+)(\\*?) (\\w+)");
  std::smatch found;
  if (std::regex_match(text, found, array)) {
    return {fmt::format("{}{} {}[{}]", found[1].str(), number_, found[2].str(), found[3].str()),
            found[2]};
  }
  if (std::regex_match(text, found, reference)) {
    const std::string name = found[3];
    const std::string of = found[2];
    if (of == kSines) {
      const std::string given = fmt::format("const {0}* sin_q, const {0}* cos_q", number_);
      return {given_sines_ ? given : "", name, Passing::sines};
    }
    if (of == "Real" && found[1].matched) return {fmt::format("{} {}", number_, name), name};
    return {fmt::format("{}{}* {}", found[1].str(), type(of), name), name, Passing::reference,
            of == "Real"};
  }
  if (!std::regex_match(text, found, value)) reject(text);
  const std::string of = found[2];
  const bool plain = of == "int" || of == "int16_t" || of == "bool";
  return {fmt::format("{}{}{} {}", found[1].str(), plain ? of : type(of), found[3].str(),
                      found[4].str()),
          found[4]};
}

void LoopTranslator::learn_signature(const LoopItem& item) {
  static const std::regex head(
      "(?:inline |constexpr |TREELINE_LINK_INLINE |TREELINE_LINK_SHARED )?(const )?([\\w<>]+?)(&?) "
      "(\\w+)\\((.*)\\) "
      "noexcept");
  std::smatch found;
  if (!std::regex_match(item.head, found, head)) reject(item.head);
  const std::string result = found[2];
  const bool plain = result == "void" || result == "int" || result == "bool";
  const bool refers = found[3].length() > 0;
  LoopSignature signature;
  signature.returns = refers ? Passing::reference : Passing::value;
  signature.result = found[1].str() + (plain ? result : type(result)) + (refers ? "*" : "");
  for (const std::string& each : split_list(item.parameters)) {
    if (each.starts_with("int ")) signature.parameters.push_back(parameter(each));
  }
  for (const std::string& each : split_list(found[5].str())) {
    signature.parameters.push_back(parameter(each));
  }
  functions_[found[4]] = signature;
  structs_.clear();
  numbers_.clear();
  returns_ = signature.returns;
  for (const LoopParameter& each : signature.parameters) {
    if (each.passing == Passing::reference)
      (each.is_number ? numbers_ : structs_).insert(each.name);
  }
}

std::string LoopTranslator::translate_function(const LoopItem& item) {
  learn_signature(item);
  const LoopSignature& signature = functions_[item.name()];
  std::vector<std::string> list;
  for (const LoopParameter& each : signature.parameters) list.push_back(each.text);
  const std::string inlining =
      item.head.starts_with(kInlined) ? fmt::format("{}\n", kInlined) : "inline ";
  std::string text =
      wrap_statements(fmt::format("static {}{} {}{}({}) {{", inlining, signature.result, name_,
                                  item.name(), joined(list)),
                      0);
  for (const std::string& line : choose_branches(join_statements(item.body))) {
    const auto [indentation, code, note] = split_line(line);
    if (code.starts_with("static_assert") || code.starts_with("using ")) continue;
    text += print_lines(statement(code), note, indentation);
  }
  return text + "}\n";
}

std::vector<std::string> LoopTranslator::choose_branches(std::vector<std::string> lines) const {
  static const std::regex branch("( *)if constexpr \\(Table::k(\\w+)\\) \\{");
  std::vector<std::string> chosen;
  std::string end;     // of the branch that a line is in
  bool is_in = false;  // whether lines are of a branch
  bool is_for = true;  // and this is for the robot
  for (std::string& line : lines) {
    std::smatch found;
    if (is_in && line == end + "}") {
      is_in = false;
      is_for = true;
    } else if (is_in && line == end + "} else {") {
      is_for = !is_for;
    } else if (std::regex_match(line, found, branch)) {
      if (is_in || table_.count(found[2]) == 0) reject(line);
      end = found[1];
      is_in = true;
      is_for = table_.at(found[2]);
    } else if (is_for) {
      chosen.push_back(is_in ? line.substr(2) : std::move(line));
    }
  }
  if (is_in) reject(lines.front());
  return chosen;
}

std::string LoopTranslator::statement(const std::string& text) {
  static const std::regex array("(const )?Real\\s?\\(&(\\w+)\\)\\[\\d+\\] = (.*);");
  static const std::regex reference("(const )?([\\w<>]+)& (\\w+) = (.*);");
  static const std::regex left_over(
      "::|<[a-zA-Z]|\\(&\\w+\\)\\[|\\b(auto|template|typename|class)\\b");
  std::string in_c;
  std::smatch found;
  if (std::regex_match(text, found, array)) {
    in_c = fmt::format("{}{}* const {} = {};", found[1].str(), number_, found[2].str(),
                       rewrite(found[3].str()));
  } else if (std::regex_match(text, found, reference)) {
    const std::string value = address(found[4]);
    (found[2] == "Real" ? numbers_ : structs_).insert(found[3]);
    in_c =
        fmt::format("{}{}* const {} = {};", found[1].str(), type(found[2]), found[3].str(), value);
  } else {
    in_c = rewrite(text);
  }
  if (std::regex_search(in_c, left_over)) reject(in_c);
  return in_c;
}

bool LoopTranslator::is_reference(const std::string& name) const {
  return structs_.count(name) + numbers_.count(name) > 0;
}

std::string LoopTranslator::address(const std::string& expression) {
  if (is_reference(expression)) return expression;
  const std::string value = rewrite(expression);
  return value.starts_with("*") ? value.substr(1) : "&" + value;
}

std::string LoopTranslator::rewrite(std::string_view text) {
  std::string in_c;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_member = in_c.ends_with('.') || in_c.ends_with("->");
    std::size_t end = at;
    while (end < text.size() && is_of_word(text[end])) ++end;
    if (end == at) {
      in_c += text[at++];
    } else if (is_member || std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
      in_c += text.substr(at, end - at);
      at = end;
    } else {
      in_c += word(text, at);
    }
  }
  return in_c;
}

/// Translates the word at `at`, with its arguments where it is called, and stops behind it.
std::string LoopTranslator::word(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  while (at < text.size() && is_of_word(text[at])) ++at;
  const std::string name(text.substr(begin, at - begin));
  const std::string_view rest = text.substr(at);
  if (name == "Real" && rest.starts_with("(")) return joined(read_list(text, at)) + suffix_;
  if (name == "Real") return number_;
  if (name == "nullptr") return "NULL";
  if (name == "constexpr") {
    ++at;  // and its blank
    return {};
  }
  if (name == "static_cast" && rest.starts_with("<void>(")) {
    at += std::string_view("<void>").size();
    return fmt::format("(void){}", read_list(text, at).front());
  }
  if (name == "return" && returns_ == Passing::reference) {
    const std::size_t end = text.find(';', at);
    const std::string value = address(std::string(text.substr(at + 1, end - at - 1)));
    at = end;
    return "return " + value;
  }
  if (name == "sin_cos" && rest.starts_with("(")) return compute_sines(read_list(text, at));
  if (name == "sines" && rest.starts_with("(")) return take_sines(read_list(text, at));
  if (functions_.count(name) > 0 && (rest.starts_with("(") || rest.starts_with("<"))) {
    return call(name, text, at);
  }
  if (types_.count(name) > 0) {
    if (rest.starts_with("<")) read_list(text, at);
    return types_[name];
  }
  if (numbers_.count(name) > 0) return "*" + name;
  if (structs_.count(name) > 0 && rest.starts_with(".")) {
    ++at;
    return name + "->";
  }
  return name;
}

std::string LoopTranslator::call(const std::string& function, std::string_view text,
                                 std::size_t& at) {
  const LoopSignature& signature = functions_[function];
  std::vector<std::string> given;
  if (text[at] == '<') {
    for (const std::string& each : read_list(text, at)) {
      if (types_.count(each) == 0 && each != "Real") given.push_back(each);
    }
  }
  for (const std::string& each : read_list(text, at)) given.push_back(each);
  if (given.size() != signature.parameters.size()) reject(text);
  std::vector<std::string> list;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Passing passing = signature.parameters[i].passing;
    list.push_back(passing == Passing::reference ? address(given[i])
                   : passing == Passing::value   ? rewrite(given[i])
                   : given_sines_                ? "sin_q, cos_q"
                                                 : "");
  }
  return fmt::format("{}{}{}({})", signature.returns == Passing::reference ? "*" : "", name_,
                     function, joined(list));
}

/// Translates the sine and cosine of a joint's angle, taken from the arguments or computed.
std::string LoopTranslator::take_sines(const std::vector<std::string>& arguments) {
  if (arguments.size() != 5) reject(joined(arguments));
  const std::string& at = arguments[2];
  const std::string& angle = arguments[3];
  const std::string& turn = arguments[4];
  const std::string call = given_sines_
                               ? fmt::format("take_sines({}, {}, {}, sin_q[{}], cos_q[{}], {})",
                                             arguments[0], arguments[1], angle, at, at, turn)
                               : fmt::format("sin_cos({0}, {1}.s, {1}.c)", angle, turn);
  return rewrite(call);
}

std::string LoopTranslator::compute_sines(const std::vector<std::string>& arguments) {
  if (arguments.size() != 3) reject(joined(arguments));
  const std::string robot = name_.substr(0, name_.size() - std::string_view("loops_").size());
  return fmt::format("{}sin_cos_of({}, {}, {})", robot, rewrite(arguments[0]),
                     address(arguments[1]), address(arguments[2]));
}

}  // namespace treeline::c
