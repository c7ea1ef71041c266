#pragma once

#include "app/procedures/tune/tune.h"

#include <QWidget>

#include <array>
#include <map>
#include <optional>
#include <string>

class QComboBox;
class QLabel;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// Chooser of the origin of the gains: a method with its targets, a shipped preset, the device, the user's
/// edits.
class TuneForm : public QWidget {
    Q_OBJECT
public:
    explicit TuneForm(QWidget* parent = nullptr);

    enum class Origin { Method, Preset, Device, Edited };
    Origin origin() const;
    /// Name of method or preset; "device" or "edited".
    std::string method() const;
    /// Only those the method reads. Errors: InvalidInput naming the field.
    Result<control::DesignTargets> targets() const;
    /// Whose presets these are.
    void setModel(const std::string& model);
    void setEdited(); ///< says so, without chosen()
    /// The same for a method, preset or other origin by its id, with its targets; an id that this version
    /// does not know counts as edited.
    void showChoice(const std::string& id, const control::DesignTargets& targets);
    /// The same as if the user had chosen it.
    void choose(const std::string& id, const control::DesignTargets& targets);

Q_SIGNALS:
    void chosen(); ///< origin or a target

protected:
    void changeEvent(QEvent* event) override;

private:
    void addOrigin(Origin origin, const std::string& id);
    void refreshWords();
    void refreshTargets();

    std::string m_model = "htm";
    QLabel* m_label = nullptr;
    QComboBox* m_origin = nullptr;
    QLabel* m_help = nullptr;
    struct Target {
        QLabel* name;
        widgets::OptionalNumberEdit* edit;
        QLabel* unit;
    };
    std::array<Target, 9> m_targets{}; ///< in the order of their table
};

/// The law of a shipped preset of this model. Errors: of findPreset and lawFromParameters.
Result<control::PositionLaw> presetLaw(const std::string& model, const std::string& name);

} // namespace halbench::app
