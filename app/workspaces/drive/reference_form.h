#pragma once

#include "app/procedures/excite/move_reference.h"
#include "app/workbench/display_quantity.h"
#include "app/workspaces/drive/axis_ranges.h"
#include "app/workspaces/drive/reference_fields.h"
#include "devices/device.h"

#include <QWidget>

#include <map>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

class NumberCheck;
class PathForm;

/// The parameters of the board's reference generator, as many as the chosen shape has
/// (resources/help/monitor.md, "Reference generator").
class ReferenceForm : public QWidget {
    Q_OBJECT

public:
    using Field = ReferenceField;

    explicit ReferenceForm(QWidget* parent = nullptr);

    /// Fields show the same motion in other units.
    void setUnits(const DisplayUnits& units);
    /// Positions of the axis in position mode, currents in the others; plateaus belong to the current modes.
    void setMode(devices::BoardMode mode, const devices::AxisSpec& axis = {});
    /// Paths that the board follows with several axes, beside its generator's shapes; in position mode.
    void setPaths(const std::vector<MoveReference::Shape>& paths);
    /// 1 ... 7, the board's codes; 7 are plateaus. A path has the code of its MoveReference::Shape.
    int shape() const;
    /// A path or table is chosen: its numbers are those of path().
    bool isPath() const { return shape() > PlateausShape; }
    PathForm& path() { return *m_path; }
    /// What the board needs to know, also from a field that was not left yet. Errors: InvalidInput,
    /// OutOfRange with what is missing; a field whose text was refused is one once (NumberCheck).
    Result<std::vector<ParameterValue>> takeValues();
    /// The largest value the reference can reach: rad or A.
    double peak() const;

Q_SIGNALS:
    void changed();
    void refused(const QString& text, const QString& remedy); ///< by a field

private:
    void addNumber(Field field);
    void label(QWidget* field, const QString& title);
    void refresh();
    void fillShapes();
    void dress(Field field);
    QString titleOf(Field field) const;
    DisplayQuantity shownAs(Field field) const;
    double valueOf(Field field) const; ///< SI
    MoveReference reference() const;
    Result<std::vector<double>> plateaus_A() const;
    Result<std::vector<ParameterValue>> plateauValues() const;
    bool isPosition() const { return m_mode == devices::BoardMode::Position; }

    DisplayUnits m_units;
    devices::BoardMode m_mode = devices::BoardMode::Position;
    devices::AxisSpec m_axis;
    QFormLayout* m_rows = nullptr;
    QComboBox* m_shape = nullptr;
    QLineEdit* m_currents = nullptr;
    PathForm* m_path = nullptr;
    std::vector<MoveReference::Shape> m_paths;
    std::map<Field, widgets::QuantityEdit*> m_numbers;
    std::map<Field, NumberCheck*> m_checks; ///< of the same
    std::map<QWidget*, QLabel*> m_labels;   ///< of the fields
};

} // namespace halbench::app
