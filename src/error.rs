//! What can go wrong in a build or when an arena is opened.

use core::fmt;

/// The reason a build or an open was refused. Queries have no errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Error {
    /// A required pointer is NULL.
    Null = 1,
    /// A descriptor's `struct_size` is smaller than its first version's, or a
    /// field unknown to this library is not zero.
    StructSize = 2,
    /// An option or enumeration is out of its range.
    InvalidValue = 3,
    /// A pointer or stride is not aligned as its type requires.
    Alignment = 4,
    /// Input, scratch, arena or output memory overlap.
    Overlap = 5,
    /// A count times a size does not fit the address space.
    Overflow = 6,
    /// A vertex index is not below its geometry's vertex count.
    IndexRange = 7,
    /// The allocator returned NULL.
    OutOfMemory = 8,
    /// The scratch or arena memory handed in is too small.
    BufferTooSmall = 9,
    /// The scene exceeds a limit: 2^30 - 1 triangles, or the references that
    /// `max_refs` allows at the voxel counts asked for.
    Limit = 10,
    /// An arena ends before its header says it does.
    Truncated = 11,
    /// The bytes do not begin with an arena's magic number.
    Magic = 12,
    /// The arena was written by an incompatible version of the format.
    Version = 13,
    /// The arena was written for, or is read on, a machine of other endianness.
    Endianness = 14,
    /// The arena's records contradict each other.
    Corrupt = 15,
    /// A bug in the library: a panic was stopped at the C boundary.
    Internal = 16,
    /// The progress callback cancelled the build.
    Cancelled = 17,
    /// The caller's threads returned before every task had been run.
    Unfinished = 18,
    /// The arena's sections are not where their counts put them: they overlap, leave
    /// gaps or the arena, or their sizes overflow.
    Sections = 19,
    /// A grid of the arena points to itself, to one before it, or to one of no lower
    /// level: a walk might go in circles.
    Cycle = 20,
    /// A voxel or a list of the arena refers to a list, triangle or grid that there is
    /// not, or out of order.
    Reference = 21,
}

impl Error {
    /// A short English sentence, without a full stop.
    #[must_use]
    pub const fn message(self) -> &'static core::ffi::CStr {
        match self {
            Self::Null => c"a required pointer is NULL",
            Self::StructSize => c"the descriptor's struct_size is not one this library knows",
            Self::InvalidValue => c"an option is out of its range",
            Self::Alignment => c"a pointer or stride is misaligned",
            Self::Overlap => c"memory regions overlap",
            Self::Overflow => c"a count times a size overflows the address space",
            Self::IndexRange => c"a vertex index is not below the vertex count",
            Self::OutOfMemory => c"the allocator returned no memory",
            Self::BufferTooSmall => c"the scratch or arena memory is too small",
            Self::Limit => c"the scene exceeds the limit on triangles or references",
            Self::Truncated => c"the arena is shorter than its header says",
            Self::Magic => c"these bytes are not a hug arena",
            Self::Version => c"the arena has an incompatible format version",
            Self::Endianness => c"the arena was written on a machine of other endianness",
            Self::Corrupt => c"the arena contradicts itself",
            Self::Internal => c"internal error in hug",
            Self::Cancelled => c"the build was cancelled",
            Self::Sections => c"the arena's sections are not where their counts put them",
            Self::Cycle => c"a grid of the arena points to one that is not below it",
            Self::Reference => c"the arena refers to a list, triangle or grid that there is not",
            Self::Unfinished => c"parallel_for returned before every task had been run",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message().to_str().unwrap_or_default())
    }
}

impl core::error::Error for Error {}
