#pragma once

#include "app/procedures/excite/move_reference_keys.h"
#include "app/procedures/excite/table_reference.h"
#include "app/workbench/display_quantity.h"

#include <QWidget>

#include <optional>
#include <vector>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

class NumberCheck;

/// The paths that a board follows with several axes; the table of poses is the last.
std::vector<MoveReference::Shape> offeredPaths(const devices::Catalogue& catalogue);
/// "Circle"; of a shape that offeredPaths() tells.
QString pathTitle(MoveReference::Shape shape);

/// The numbers of a path, or the file of a table of poses with its limits (resources/help/monitor.md,
/// "Reference generator"). Which they are, their limits and their words are those of the table of keys that
/// the command line uses.
class PathForm : public QWidget {
    Q_OBJECT

public:
    explicit PathForm(QWidget* parent = nullptr);

    void setUnits(const DisplayUnits& units);
    void setShape(MoveReference::Shape shape);
    /// What was read of the file that was asked for.
    void setTable(const QString& path, Result<PoseTable> table);

    /// The path as it is shown. Errors: what is missing or refused (of the reference, of the table).
    Result<MoveReference> reference() const;
    /// Likewise, also of a field that was not left yet; a field whose text was refused is an error once.
    Result<MoveReference> take();

Q_SIGNALS:
    void changed();
    void refused(const QString& text, const QString& remedy); ///< by a field
    void fileWanted();                                        ///< Choose file was pressed

private:
    struct Row {
        ReferenceSetting setting;
        SettingSpec spec;
        widgets::QuantityEdit* field;
        NumberCheck* check;
        QLabel* label;
    };

    void addRow(const ReferenceSetting& setting);
    void buildFile();
    void dress(Row& row) const;
    void layOut();
    void say();
    Row& rowOf(const ReferenceSetting& setting);
    const Row& rowOf(const ReferenceSetting& setting) const;
    Result<void> setIn(MoveReference& reference, const Row& row) const;

    DisplayUnits m_units;
    MoveReference::Shape m_shape = MoveReference::Shape::Circle;
    QFormLayout* m_layout = nullptr;
    std::vector<Row> m_rows;
    QWidget* m_fileRow = nullptr;
    QLineEdit* m_file = nullptr;
    QLabel* m_fileLabel = nullptr;
    QLabel* m_note = nullptr; ///< travel time, or what is refused
    std::optional<Result<PoseTable>> m_table;
};

} // namespace halbench::app
