//! What is wrong with a sensor, in a word.

use dolmen::signal::ChannelFault;

/// The channel of a fault, and the word by which a store keeps it.
pub fn fault_word(fault: &ChannelFault) -> (String, &'static str) {
    let (channel, word) = match fault {
        ChannelFault::Constant { channel, .. } => (channel, "dead"),
        ChannelFault::Faint { channel, .. } => (channel, "faint"),
        ChannelFault::Stuck { channel, .. } => (channel, "stuck"),
        ChannelFault::Faded { channel, .. } => (channel, "faded"),
        ChannelFault::Alike { channel, .. } => (channel, "alike"),
        ChannelFault::Drifts { channel, .. } => (channel, "drifts"),
        ChannelFault::Spikes { channel, .. } => (channel, "spikes"),
        ChannelFault::Clipped { channel, .. } => (channel, "clipped"),
        ChannelFault::Duplicated { channel, .. } => (channel, "duplicated"),
    };
    (channel.clone(), word)
}
