// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts for users are written in plain technical English: no word of the list below is
// used in README.md, CONTRIBUTING.md, CHANGELOG.md, the help pages, or string literals of the window, the
// command line, and the parts of the solver that write messages and help. Comments,
// includes, and code in Markdown are not checked. Keys, states and event names of files
// are exempt through `exceptions`, where each entry gives its reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct BannedWord {
    std::string phrase;  // lower case, words separated by one space
    std::string instead;
};

const std::vector<BannedWord> bannedWords{
    {"anew", "again"},
    {"tell", "say, report, show or print"},
    {"tells", "says, reports, shows or prints"},
    {"told", "said, reported, shown or printed"},
    {"telling", "saying, reporting, showing or printing"},
    {"stands", "is, appears; of rock: is stable"},
    {"goes on", "continues or resumes"},
    {"go on", "continue or resume"},
    {"going on", "continuing or in progress"},
    {"lets go", "fails, debonds or is released"},
    {"let go", "failed, debonded or released"},
    {"letting go", "failing, debonding or releasing"},
    {"held to", "checked against"},
    {"person", "the user, or the passive voice"},
    {"persons", "users, or the passive voice"},
    {"somebody", "the user, or the passive voice"},
    {"nobody", "no user, or the passive voice"},
    {"whoever", "code, or the user, that ..."},
    {"whatever", "any, or independent of"},
    {"beside", "next to, besides or compared with"},
    {"the card", "the GPU"},
    {"is asked for", "is required, or an imperative: enter ..."},
    {"are asked for", "are required, or an imperative: enter ..."},
    {"gone on with", "resumed"},
    {"at hand", "available"},
    {"the books", "the energy balance"},
    {"comes of it", "results"},
    {"once more takes it away", "again: closes it"},
};

struct Exception {
    std::string file;  // relative to the root
    std::string fragment;  // of the text, which allows the word inside it; without a space: the whole text
    std::string reason;
    friend std::ostream& operator<<(std::ostream& out, const Exception& e) {
        return out << e.file << " \"" << e.fragment << "\" (" << e.reason << ")";
    }
};

const std::vector<Exception> exceptions{
    {"app/cli/json_answers.cpp", "stands", "key of the JSON answers"},
    {"app/cli/json_answers.cpp", "stands-at-1000", "value of \"answer\" in the JSON of keyblock safety"},
    {"app/cli/safety_folder.cpp", "stands", "column of safety.csv"},
    {"app/cli/safety_folder.cpp", "stands.kbrun", "name of a file in the folder of keyblock safety"},
    {"solver/scene/check_watch.cpp", "quantity 'stands'", "a quantity of the scene format"},
    {"solver/scene/field_rows.cpp", "`stands` (1 if", "a quantity of the scene format"},
    {"solver/scene/quantity_text.cpp", "stands", "a quantity of the scene format"},
    {"solver/scene/quantity_text.cpp", "factor_of_safety or stands;", "a quantity of the scene format"},
    {"solver/trade/trade_point.cpp", "stands", "a quantity of the scene format"},
    {"solver/trade/trade_errors.cpp", "stands", "a quantity of the scene format"},
    {"solver/trade/stress.cpp", "stands", "a quantity of the scene format"},
};

/// A text for users with the line of each of its characters.
struct Text {
    std::string characters;
    std::vector<int> lines;

    void add(char character, int line) {
        characters += character == '\n' || character == '\t' ? ' ' : character;
        lines.push_back(line);
    }
};

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

struct Word {
    std::string lower;
    std::size_t begin, end;
};

std::vector<Word> wordsOf(std::string_view text) {
    std::vector<Word> words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isWordCharacter(text[i])) continue;
        Word word{{}, i, i};
        for (; i < text.size() && isWordCharacter(text[i]); ++i)
            word.lower += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
        word.end = i;
        words.push_back(std::move(word));
    }
    return words;
}

/// Whether the words from `first` on are those of `phrase`, with nothing but spaces between them.
bool isPhraseAt(std::string_view text, const std::vector<Word>& words, std::size_t first,
                const std::vector<Word>& phrase) {
    if (first + phrase.size() > words.size()) return false;
    for (std::size_t k = 0; k < phrase.size(); ++k) {
        const Word& word = words[first + k];
        if (word.lower != phrase[k].lower) return false;
        if (k > 0) {
            const std::size_t from = words[first + k - 1].end;
            if (text.substr(from, word.begin - from).find_first_not_of(' ') != std::string_view::npos) return false;
        }
    }
    return true;
}

struct Hit {
    std::string file;
    int line;
    BannedWord word;
    const Exception* exception;  // null where none applies
};

/// The exception whose fragment covers the characters from `begin` to `end`.
const Exception* exceptionFor(const std::string& file, const std::string& text, std::size_t begin, std::size_t end,
                              const std::vector<Exception>& allowed) {
    for (const Exception& each : allowed) {
        if (each.file != file) continue;
        const bool isWhole = each.fragment.find(' ') == std::string::npos;
        if (isWhole && each.fragment != text) continue;
        for (std::size_t at = text.find(each.fragment); at != std::string::npos; at = text.find(each.fragment, at + 1))
            if (at <= begin && end <= at + each.fragment.size()) return &each;
    }
    return nullptr;
}

std::vector<Hit> hitsIn(const std::string& file, const std::vector<Text>& texts,
                        const std::vector<Exception>& allowed = exceptions) {
    static const std::vector<std::vector<Word>> phrases = [] {
        std::vector<std::vector<Word>> split;
        for (const BannedWord& banned : bannedWords) split.push_back(wordsOf(banned.phrase));
        return split;
    }();
    std::vector<Hit> hits;
    for (const Text& text : texts) {
        const std::vector<Word> words = wordsOf(text.characters);
        for (std::size_t i = 0; i < words.size(); ++i)
            for (std::size_t k = 0; k < phrases.size(); ++k)
                if (isPhraseAt(text.characters, words, i, phrases[k])) {
                    const std::size_t begin = words[i].begin, end = words[i + phrases[k].size() - 1].end;
                    hits.push_back({file, text.lines[begin], bannedWords[k],
                                    exceptionFor(file, text.characters, begin, end, allowed)});
                }
    }
    return hits;
}

/// The prose of a Markdown page: all but fenced code, code spans and comments.
std::vector<Text> proseOf(std::string_view page) {
    Text prose;
    int line = 1;
    bool isFence = false, isSpan = false, isComment = false;
    for (std::size_t i = 0; i < page.size(); ++i) {
        const std::string_view rest = page.substr(i);
        if (!isComment && !isSpan && rest.starts_with("```")) {
            isFence = !isFence;
            i += 2;
        } else if (!isFence && rest.starts_with("<!--")) {
            isComment = true;
        } else if (isComment && rest.starts_with("-->")) {
            isComment = false;
            i += 2;
        } else if (!isFence && !isComment && page[i] == '`') {
            isSpan = !isSpan;
            prose.add('`', line);
        } else if (!isFence && !isComment && !isSpan) {
            prose.add(page[i], line);
        }
        if (page[i] == '\n') {
            ++line;
            if (rest.starts_with("\n\n")) isSpan = false;
        }
    }
    return {prose};
}

/// Reads the string literals of C++ sources, neighbours as one text.
class LiteralReader {
public:
    explicit LiteralReader(std::string_view source) : source_(source) {}

    std::vector<Text> read() {
        while (at_ < source_.size()) {
            if (isNext("//")) skipPast("\n");
            else if (isNext("/*")) skipPast("*/");
            else if (source_[at_] == '#' && isDirective("include")) skipPast("\n");
            else if (source_[at_] == '\'') readCharacter();
            else if (isRawNext()) readRaw();
            else if (source_[at_] == '"') readLiteral();
            else {
                if (!std::isspace(static_cast<unsigned char>(source_[at_]))) isNeighbour_ = false;
                advance();
            }
        }
        return texts_;
    }

private:
    bool isNext(std::string_view start) const { return source_.substr(at_).starts_with(start); }

    bool isRawNext() const { return isNext("R\"") && (at_ == 0 || !isWordCharacter(source_[at_ - 1])); }

    bool isDirective(std::string_view name) const {
        const std::size_t begin = source_.find_first_not_of(" \t", at_ + 1);
        return begin != std::string_view::npos && source_.substr(begin).starts_with(name);
    }

    void advance() {
        if (source_[at_] == '\n') ++line_;
        ++at_;
    }

    void skipPast(std::string_view end) {
        const std::size_t found = source_.find(end, at_);
        const std::size_t until = found == std::string_view::npos ? source_.size() : found + end.size();
        while (at_ < until) advance();
    }

    /// A character literal, or the separator of digits in 10'000.
    void readCharacter() {
        const bool isSeparator = at_ > 0 && isWordCharacter(source_[at_ - 1]);
        advance();
        isNeighbour_ = false;
        if (isSeparator) return;
        while (at_ < source_.size() && source_[at_] != '\'') {
            if (source_[at_] == '\\') advance();
            if (at_ < source_.size()) advance();
        }
        if (at_ < source_.size()) advance();
    }

    Text& text() {
        if (!isNeighbour_) texts_.emplace_back();
        isNeighbour_ = true;
        return texts_.back();
    }

    void readRaw() {
        at_ += 2;
        const std::size_t open = source_.find('(', at_);
        if (open == std::string_view::npos) return;
        const std::string end = ")" + std::string(source_.substr(at_, open - at_)) + "\"";
        at_ = open + 1;
        Text& target = text();
        while (at_ < source_.size() && !isNext(end)) {
            target.add(source_[at_], line_);
            advance();
        }
        at_ = std::min(at_ + end.size(), source_.size());
    }

    void readLiteral() {
        advance();
        Text& target = text();
        while (at_ < source_.size() && source_[at_] != '"') {
            if (source_[at_] == '\\' && at_ + 1 < source_.size()) {
                advance();
                target.add(source_[at_] == 'n' || source_[at_] == 't' ? ' ' : source_[at_], line_);
            } else {
                target.add(source_[at_], line_);
            }
            advance();
        }
        if (at_ < source_.size()) advance();
    }

    std::string_view source_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool isNeighbour_ = false;
    std::vector<Text> texts_;
};

std::vector<Text> literalsOf(std::string_view source) { return LiteralReader(source).read(); }

std::string contentOf(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The files whose texts are checked, relative to the root.
std::vector<std::string> checkedFiles(const fs::path& root) {
    std::vector<std::string> files{"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
    const auto addBelow = [&](const char* folder, const std::vector<std::string>& extensions) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (std::ranges::count(extensions, entry.path().extension().string()))
                files.push_back(entry.path().lexically_relative(root).generic_string());
    };
    addBelow("resources/help", {".md"});
    for (const char* folder :
         {"ui", "app", "solver/scene", "solver/run", "solver/files", "solver/results", "solver/trade"})
        addBelow(folder, {".h", ".cpp"});
    std::ranges::sort(files);
    return files;
}

std::vector<Hit> hitsOfFile(const fs::path& root, const std::string& file) {
    const std::string content = contentOf(root / file);
    return hitsIn(file, file.ends_with(".md") ? proseOf(content) : literalsOf(content));
}

TEST(BannedWords, TextsForUsersHaveNone) {
    const fs::path root = KEYBLOCK_SOURCE_DIR;
    const std::vector<std::string> files = checkedFiles(root);
    EXPECT_GT(files.size(), 100u);
    std::vector<const Exception*> used;
    for (const std::string& file : files)
        for (const Hit& hit : hitsOfFile(root, file)) {
            if (hit.exception) used.push_back(hit.exception);
            else ADD_FAILURE() << hit.file << ":" << hit.line << ": \"" << hit.word.phrase << "\"; write: " << hit.word.instead;
        }
    for (const Exception& each : exceptions)
        EXPECT_TRUE(std::ranges::count(used, &each)) << "no longer needed, remove it from `exceptions`: " << each;
}

TEST(BannedWords, EveryExceptionGivesItsReason) {
    for (const Exception& each : exceptions) EXPECT_FALSE(each.reason.empty()) << each;
}

TEST(BannedWords, LiteralIsFoundWithItsLine) {
    const std::vector<Hit> hits = hitsIn("made_up.cpp", literalsOf("int a;\nauto b = \"The run\"\n    \" goes \" \"on\";\n"));
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].line, 3);
    EXPECT_EQ(hits[0].word.phrase, "goes on");
}

TEST(BannedWords, LiteralAfterOtherTokensIsFound) {
    const auto count = [](const char* source) { return hitsIn("made_up.cpp", literalsOf(source)).size(); };
    EXPECT_EQ(count("f('\"', 10'000, \"Anew\");"), 1u);
    EXPECT_EQ(count("f(\"\\\\\", \"say \\\"anew\\\"\");"), 1u);
    EXPECT_EQ(count("auto s = R\"x(what \"stands\" )\" here)x\";"), 1u);
    EXPECT_EQ(count("tr(\"a person's\\nname\");"), 1u);
}

TEST(BannedWords, CommentsIncludesAndNamesAreNotChecked) {
    const auto count = [](const char* source) { return hitsIn("made_up.cpp", literalsOf(source)).size(); };
    EXPECT_EQ(count("// \"anew\"\n/* \"anew\" */\n#include \"ui/beside/anew.h\"\n"), 0u);
    EXPECT_EQ(count("int anew = f(\"goes\", \"on\");"), 0u);  // two texts
    EXPECT_EQ(count("f(\"personal besides let, go\");"), 0u);  // no whole words
}

TEST(BannedWords, MarkdownCodeIsNotChecked) {
    const std::vector<Hit> hits = hitsIn("made_up.md", proseOf("<!-- anew -->\n`make anew` goes\non\n```\nbeside\n```\nHeld to\n"));
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].line, 2);
    EXPECT_EQ(hits[1].word.phrase, "held to");
    EXPECT_EQ(hits[1].line, 7);
}

TEST(BannedWords, ExceptionCoversItsFragmentOnly) {
    const std::vector<Exception> allowed{{"made_up.cpp", "x-card of the card", "an example"}};
    const std::vector<Hit> hits = hitsIn("made_up.cpp", literalsOf("f(\"x-card of the card, the card\");"), allowed);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_TRUE(hits[0].exception);
    EXPECT_FALSE(hits[1].exception);
}

TEST(BannedWords, ExceptionOfAKeyDoesNotCoverASentence) {
    const std::vector<Exception> allowed{{"made_up.cpp", "stands", "a key"}};
    const std::vector<Hit> hits = hitsIn("made_up.cpp", literalsOf("f(\"stands\", \"it stands\");"), allowed);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_TRUE(hits[0].exception);
    EXPECT_FALSE(hits[1].exception);
}

}  // namespace
