/// Why modes cannot be identified. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModalError {
    /// The highest model order asked needs more block rows than there are.
    #[error(
        "order_most is {given}, but {block_rows} block rows of {channels} channels allow at most {most}: raise \
         block_rows or lower order_most"
    )]
    Order {
        /// Order asked.
        given: usize,
        /// Block rows.
        block_rows: usize,
        /// Channels.
        channels: usize,
        /// Largest order allowed.
        most: usize,
    },
}
