"""Every operation of the protocol as a function.

Operations on a map are methods of the map as well. All take these keywords:

"""

from . import _operations

__doc__ += "\n".join(f"{name}\n    {meaning}" for name, meaning in _operations.COMMON.items()) + "\n"
__all__ = [operation.python_name for operation in _operations.ALL]

globals().update({operation.python_name: operation.function() for operation in _operations.ALL})
