#include "devices/simulated/planar/simulated_planar.h"
#include "models/planar/planar_parameters.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

// Keys of the address sim:planar against those that the help page lists, not against the program's own list.

namespace halbench::devices {
namespace {

struct Row {
    std::vector<std::string> keys; ///< "`coil_gain_1` ... `coil_gain_6`": all six
    std::vector<std::string> cells;
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        parts.push_back(text.substr(from, at - from));
        from = at + separator.size();
    }
    parts.push_back(text.substr(from));
    return parts;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> keysIn(const std::string& cell) {
    std::vector<std::string> keys;
    const std::vector<std::string> parts = split(cell, "`");
    for (std::size_t i = 1; i < parts.size(); i += 2) {
        keys.push_back(parts[i]);
    }
    if (keys.size() == 2 && cell.find("...") != std::string::npos) {
        const std::string stem = keys[0].substr(0, keys[0].size() - 1);
        const char last = keys[1].back();
        keys.clear();
        for (char number = '1'; number <= last; ++number) {
            keys.push_back(stem + number);
        }
    }
    return keys;
}

/// The rows of the table of the page whose heading begins with these words.
std::vector<Row> tableOfHelp(const std::string& heading) {
    std::ifstream page(std::string(HALBENCH_SOURCE_DIR) + "/resources/help/planar-theory.md");
    std::vector<Row> rows;
    bool isInside = false;
    for (std::string line; std::getline(page, line);) {
        isInside = isInside ? line.starts_with("|") : line.starts_with(heading);
        if (isInside && line.find('`') != std::string::npos) {
            Row row;
            for (const std::string& cell : split(line, "|")) {
                row.cells.push_back(trimmed(cell));
            }
            row.keys = keysIn(row.cells.at(1));
            rows.push_back(row);
        }
    }
    return rows;
}

/// "likewise 2, 3" of a chip stands for rows that are not written.
void addOtherChips(std::vector<Row>& rows) {
    const std::size_t written = rows.size();
    for (std::size_t i = 0; i < written; ++i) {
        if (rows[i].cells.at(5).find("likewise 2, 3") != std::string::npos) {
            for (const char* chip : {"hall2", "hall3"}) {
                rows.push_back({{chip + rows[i].keys.at(0).substr(5)}, rows[i].cells});
            }
        }
    }
}

std::vector<Row> parameterRows() {
    std::vector<Row> rows = tableOfHelp("| key | value | unit | tag | meaning |");
    addOtherChips(rows);
    return rows;
}

Result<void> check(const Overrides& overrides) {
    return planarModel().check(overrides);
}

TEST(PlanarOverrides, addressTakesEveryValueOfTheHelpPageAsItStandsThere) {
    const std::vector<Row> rows = parameterRows();
    ASSERT_GT(rows.size(), 60U);
    for (const Row& row : rows) {
        const std::vector<std::string> values = split(row.cells.at(2), ", ");
        for (std::size_t i = 0; i < row.keys.size(); ++i) {
            const bool isDrawn = row.cells.at(2) == "drawn";
            const std::string value = isDrawn ? "0" : values.at(i);
            const auto taken = check({{row.keys[i], value}});
            EXPECT_TRUE(taken) << row.keys[i] << "=" << value << ": " << taken.error().message;
            if (!isDrawn) {
                const double present =
                    models::planarParameter(models::PlanarParameters{}, row.keys[i]).value_or(NAN);
                const std::vector<std::string> words = models::planarParameterWords(row.keys[i]);
                const auto word = std::find(words.begin(), words.end(), value);
                const double stated =
                    words.empty() ? std::stod(value) : static_cast<double>(word - words.begin());
                EXPECT_NEAR(present, stated, 1e-6 * std::fabs(present)) << row.keys[i];
            }
        }
    }
}

TEST(PlanarOverrides, helpPageListsEveryKeyOfTheAddress) {
    std::set<std::string> listed;
    for (const Row& row : parameterRows()) {
        listed.insert(row.keys.begin(), row.keys.end());
    }
    for (const Row& row : tableOfHelp("| symbol | SI | key |")) {
        listed.insert(row.keys.begin(), row.keys.end());
    }
    listed.insert({"seed", "imperfections", "chain"}); // of command-line.md
    const std::vector<std::string> known = split(planarModel().overrides, ", ");
    EXPECT_EQ(std::set<std::string>(known.begin(), known.end()), listed);
}

// Symbol, SI, key: the same value twice, once in SI and once in the unit that the key ends with.
TEST(PlanarOverrides, symbolsAreTheirKeysInSi) {
    const std::map<std::string, double> prefixes = {{"mm", 1e-3}, {"mT", 1e-3}, {"uT", 1e-6}};
    const std::vector<Row> rows = tableOfHelp("| symbol | SI | key |");
    ASSERT_GE(rows.size(), 8U);
    for (const Row& row : rows) {
        const std::string symbol = row.keys.at(0);
        const std::string key = keysIn(row.cells.at(3)).at(0);
        const double si_per_unit = prefixes.at(key.substr(key.rfind('_') + 1));
        models::PlanarParameters parameters;
        const double wanted = 1.1 * *models::planarParameter(parameters, key);
        ASSERT_TRUE(models::setPlanarParameter(parameters, symbol, wanted * si_per_unit)) << symbol;
        EXPECT_NEAR(*models::planarParameter(parameters, key), wanted, 1e-12 * wanted) << symbol;
        EXPECT_TRUE(check({{symbol, fmt::format("{}", wanted * si_per_unit)}})) << symbol;
    }
}

TEST(PlanarOverrides, valueUnderBothNamesIsRefused) {
    const auto checked = check({{"sigma_B", "2e-5"}, {"hall_noise_uT", "20"}});
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(checked.error().message, "sigma_B and hall_noise_uT are the same value");
}

TEST(PlanarOverrides, symbolOutOfRangeIsToldInItsUnit) {
    const auto checked = check({{"sigma_B", "18"}}); // as if it were uT
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(checked.error().message, "sigma_B = 18 is out of range");
    EXPECT_THAT(checked.error().hint, ::testing::StartsWith("Allowed: 0 to 0.005 T."));
}

} // namespace
} // namespace halbench::devices
