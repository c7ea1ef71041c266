#pragma once

#include "app/documents/model_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The name in a project of the gains that are worked on.
constexpr const char* DesignInUse = "in use";

/// Gains kept under a name beside those that are worked on.
struct KeptDesign {
    std::string name;
    std::string document;           ///< halbench.gains/1, as the project holds it
    std::optional<GainsFile> gains; ///< nothing: the document cannot be read, and stays as it is
    bool isDrawn = true;
};

/// The named designs of a project, with what was done to them undone and redone in order. Names are unique.
class SavedDesigns {
public:
    const std::vector<KeptDesign>& all() const { return m_designs; }

    /// As a project holds them; nothing before it can be undone.
    void restore(std::vector<KeptDesign> designs);
    /// Under `stem` or, when that is taken, "stem 2", "stem 3" ...; where it stands.
    std::size_t keep(const std::string& stem, std::string document);
    /// The same for one that is to be kept whatever is undone; what was done before can still be undone.
    /// Returns its name.
    std::string adopt(const std::string& stem, std::string document);
    /// Errors: InvalidInput for a name that is empty or taken, also by the one in use; nothing changes.
    Result<void> rename(std::size_t at, const std::string& name);
    void remove(std::size_t at);
    void draw(std::size_t at, bool isDrawn); ///< no change to undo

    bool canUndo() const { return !m_undo.empty(); }
    bool canRedo() const { return !m_redo.empty(); }
    void undo();
    void redo();

private:
    std::string freeName(const std::string& stem) const;
    void remember();

    std::vector<KeptDesign> m_designs;
    std::vector<std::vector<KeptDesign>> m_undo;
    std::vector<std::vector<KeptDesign>> m_redo;
};

/// With its gains read, if they can be.
KeptDesign keptDesign(std::string name, std::string document);

} // namespace halbench::app
