#pragma once

#include "control/base/block_columns.h"
#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <memory>
#include <string>
#include <vector>

namespace halbench::devices {

/// A signal that is computed from others, as a project keeps it.
struct DerivedSignal {
    std::string name;
    std::string expression; ///< of names of signals, in SI: "current.a^2 + current.b^2"
    std::string unit;       ///< of the value; empty: as it follows from the expression

    bool operator==(const DerivedSignal&) const = default;
};

/// "NAME = EXPRESSION" or "NAME [UNIT] = EXPRESSION". Errors: InvalidInput.
Result<DerivedSignal> parseDerivedSignal(const std::string& text);

/// What an expression comes to.
struct Derivation {
    std::vector<std::string> sources; ///< the signals it needs
    std::string unit;
};

/// Errors: InvalidInput with the column of the mistake: a name that is taken or no name, an expression that
/// cannot be read, a signal that is not known, a unit that neither stands there nor follows.
Result<Derivation> deriveSignal(const DerivedSignal& derived, const std::vector<StreamLayout::Column>& known);

/// Computes derived signals row by row as blocks come. Belongs to one thread.
class DerivedSignals {
public:
    DerivedSignals();
    ~DerivedSignals();

    /// Those that cannot be computed from what is known are left out.
    void set(const std::vector<DerivedSignal>& list, const std::vector<StreamLayout::Column>& known);

    /// Those that are computed.
    struct Computed {
        DerivedSignal signal; ///< with its unit
        std::vector<std::string> sources;
    };
    std::vector<Computed> computed() const;

    /// Adds a column for each whose sources are all in the block; NaN where one is missing or where the
    /// result is no number. Computed from the values that `columns` has for the block so far.
    void addTo(BlockColumns& columns, const SampleBlock& block);

private:
    struct Formula;

    std::shared_ptr<const StreamLayout> layoutWith(const StreamLayout& layout,
                                                   const std::vector<Formula*>& formulas);

    std::vector<std::unique_ptr<Formula>> m_formulas;
    std::shared_ptr<const StreamLayout> m_from; ///< kept, so that its address stays taken
    std::shared_ptr<const StreamLayout> m_to;   ///< of blocks with the layout m_from
};

/// The recording with a column more for each. Errors: those of deriveSignal().
Result<Recording> withDerived(Recording recording, const std::vector<DerivedSignal>& list);

} // namespace halbench::devices
