#include "app/workspaces/tune/saved_designs.h"

#include "app/documents/filtered_gains.h"
#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

bool hasName(const std::vector<KeptDesign>& designs, const std::string& name) {
    return name == DesignInUse || std::any_of(designs.begin(), designs.end(),
                                              [&](const KeptDesign& design) { return design.name == name; });
}

} // namespace

KeptDesign keptDesign(std::string name, std::string document) {
    auto gains = parseFilteredGains(document, name);
    return {std::move(name), std::move(document), gains ? std::optional(*std::move(gains)) : std::nullopt,
            true};
}

void SavedDesigns::restore(std::vector<KeptDesign> designs) {
    m_designs = std::move(designs);
    m_undo.clear();
    m_redo.clear();
}

/// Free also in what undo and redo bring back.
std::string SavedDesigns::freeName(const std::string& stem) const {
    const auto isTaken = [this](const std::string& name) {
        const auto isIn = [&name](const std::vector<KeptDesign>& designs) { return hasName(designs, name); };
        return isIn(m_designs) || std::any_of(m_undo.begin(), m_undo.end(), isIn) ||
               std::any_of(m_redo.begin(), m_redo.end(), isIn);
    };
    std::string name = stem;
    for (std::size_t number = 2; isTaken(name); ++number) {
        name = fmt::format("{} {}", stem, number);
    }
    return name;
}

void SavedDesigns::remember() {
    m_undo.push_back(m_designs);
    m_redo.clear();
}

std::size_t SavedDesigns::keep(const std::string& stem, std::string document) {
    remember();
    m_designs.push_back(keptDesign(freeName(stem), std::move(document)));
    return m_designs.size() - 1;
}

std::string SavedDesigns::adopt(const std::string& stem, std::string document) {
    const KeptDesign adopted = keptDesign(freeName(stem), std::move(document));
    for (auto* history : {&m_undo, &m_redo}) {
        for (std::vector<KeptDesign>& designs : *history) {
            designs.push_back(adopted);
        }
    }
    m_designs.push_back(adopted);
    return adopted.name;
}

Result<void> SavedDesigns::rename(std::size_t at, const std::string& name) {
    HB_ASSERT(at < m_designs.size());
    if (m_designs[at].name == name) {
        return {};
    }
    if (name.empty() || hasName(m_designs, name)) {
        return failure(ErrorCode::InvalidInput,
                       name.empty() ? "a design needs a name"
                                    : fmt::format("design '{}' exists already", name),
                       "choose another name");
    }
    remember();
    m_designs[at].name = name;
    return {};
}

void SavedDesigns::remove(std::size_t at) {
    HB_ASSERT(at < m_designs.size());
    remember();
    m_designs.erase(m_designs.begin() + static_cast<std::ptrdiff_t>(at));
}

void SavedDesigns::draw(std::size_t at, bool isDrawn) {
    HB_ASSERT(at < m_designs.size());
    m_designs[at].isDrawn = isDrawn;
}

void SavedDesigns::undo() {
    HB_ASSERT(canUndo());
    m_redo.push_back(std::exchange(m_designs, std::move(m_undo.back())));
    m_undo.pop_back();
}

void SavedDesigns::redo() {
    HB_ASSERT(canRedo());
    m_undo.push_back(std::exchange(m_designs, std::move(m_redo.back())));
    m_redo.pop_back();
}

} // namespace halbench::app
