#pragma once

#include <QWidget>

#include <vector>

class QHBoxLayout;

namespace halbench::app {

/// Number of columns of at least this width beside each other, at most one a part.
int columnsIn(int width_px, int least_px, int parts);

/// Parts of a page in columns beside each other; where there is room for fewer, the last column holds the
/// remaining parts below each other. A wide place stretches no column beyond a readable line.
class SideColumns : public QWidget {
    Q_OBJECT

public:
    explicit SideColumns(QWidget* parent);

    /// After the parts that are there; the columns share the width in the ratio of their first part's share.
    void addPart(QWidget& part, int share = 1);
    int columns() const { return m_columns; }
    /// One column: the place decides how many there are, not the other way round.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fit();
    void arrange(int columns);

    struct Part {
        QWidget* widget = nullptr;
        int share = 1;
    };

    std::vector<Part> m_parts;
    QHBoxLayout* m_row = nullptr;
    int m_columns = 0;
};

} // namespace halbench::app
