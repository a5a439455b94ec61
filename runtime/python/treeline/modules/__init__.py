"""The modules that `treeline.load` made, each under a name that tells its content: so that `pickle` finds them in
other processes too. They lie in the cache."""

from treeline._cache import find_folder

__path__ = [str(find_folder())]
