#pragma once

#include <QSplitter>

#include <vector>

namespace halbench::widgets {

/// A splitter whose parts keep their shares of the room, exactly as they were given or dragged, whatever
/// becomes of the room: a window that is made small and large again has its parts as they were, and what is
/// kept of them is not rounded anew to the pixels of each screen. A part is never made smaller than it can
/// be; the others then have less.
class ShareSplitter : public QSplitter {
    Q_OBJECT
public:
    explicit ShareSplitter(Qt::Orientation orientation, QWidget* parent = nullptr);

    /// One for each part, relative to each other: 1 and 3 are a quarter and three quarters. Other counts than
    /// there are parts share the room evenly.
    void setShares(std::vector<double> shares);
    const std::vector<double>& shares() const { return m_shares; }
    /// One part grows at the cost of the others, or shrinks. False: there is no room for that.
    bool grow(int part, double factor);
    void shareEvenly();

Q_SIGNALS:
    void sharesChanged(); ///< by the user: those of the sizes that are shown, with a mean of 1

protected:
    QSplitterHandle* createHandle() override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void apply();
    std::vector<double> shownShares() const;
    void take();

    std::vector<double> m_shares;
};

/// With a mean of 1, to a hundredth: what a file keeps of sizes.
std::vector<double> settledShares(std::vector<double> shares);

} // namespace halbench::widgets
