#pragma once

#include "app/procedures/tune/tune.h"
#include "widgets/language/display_units.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// The gains of the position law in A/rad or A/deg, in parallel, standard or series form, the feed-forward
/// and the friction assist behind a button. What is no number never leaves it; what leaves it is parallel.
class GainEditor : public QWidget {
    Q_OBJECT
public:
    explicit GainEditor(QWidget* parent = nullptr);

    /// The preferred one; who chooses another here has it until the preference changes.
    void setAngleUnit(widgets::AngleUnit unit);
    void setLaw(const control::PositionLaw& law);
    /// Errors: InvalidInput naming the field; of lawFromParameters.
    Result<control::PositionLaw> law() const;

Q_SIGNALS:
    void edited(); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* name;
        widgets::OptionalNumberEdit* edit;
        QLabel* unit;
        ParameterValue value; ///< SI
        bool isExtra;
    };
    void addRow(const ParameterValue& value, bool isExtra);
    void refreshWords();
    void refreshNumbers();
    void refreshForm();
    bool showTimes(control::PidForm form);
    void takeTimes();
    void sayNames();
    control::PidForm form() const;
    control::PidGains parallelGains() const;
    void showExtras(bool isShown);
    widgets::DisplayUnit unitOf(const Row& row) const;

    std::vector<Row> m_rows;
    QGridLayout* m_grid = nullptr;
    QComboBox* m_form = nullptr;
    QLabel* m_note = nullptr;       ///< why a form is not shown
    std::optional<Error> m_noGains; ///< what is written as times is no controller
    QComboBox* m_unit = nullptr;
    QToolButton* m_extras = nullptr;
};

} // namespace halbench::app
